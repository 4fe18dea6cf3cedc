// figure.svg and figure.png: force against depth, atoms, membrane and Eq. 16 (the paper's Figure 2).
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "compare/results/result.hpp"

namespace validate {

/// Size of a drawing: SVG units; the PNG has twice as many pixels.
struct DrawingSize {
  int width = 900, height = 640;
};

/// Draws `folder`/`name`.svg and .png from gnuplot commands (data blocks, settings, plot). A system without
/// gnuplot gets neither: nothing is thrown and the return value says so, as it says what gnuplot warned of.
/// Throws Error (file failed) with gnuplot's message when it fails, or when its PNG is empty.
std::optional<std::string> draw(const std::string& commands, const std::filesystem::path& folder,
                                const std::string& name, DrawingSize size = {});

/// A run's figure.
std::optional<std::string> write_figure(const Result& result, const std::filesystem::path& folder);

/// A run's fits against the largest depth used: window_scan.svg and .png. Nothing is drawn where nothing is
/// fitted.
std::optional<std::string> write_scan_figure(const Result& result, const std::filesystem::path& folder);

}  // namespace validate
