// The files of a drawing: NAME.svg, NAME.png, NAME.pdf, and what is drawn as NAME.csv.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compare/documents/plots/gnuplot_writer.hpp"
#include "compare/documents/plots/plot.hpp"

namespace validate {

/// Draws `folder`/`name`.svg, .png and .pdf, or those asked for. A system without gnuplot gets none: nothing is thrown
/// and the return value says so, as it says what gnuplot warned of. Throws Error (file failed) with gnuplot's message
/// when it fails, or when its PNG is empty. A plot without panels makes no files.
std::optional<std::string> draw(const Plot& plot, const std::filesystem::path& folder, const std::string& name,
                                const std::vector<PictureFormat>& formats = {PictureFormat::svg, PictureFormat::png,
                                                                             PictureFormat::pdf});

/// The same, and what is drawn as `folder`/`name`.csv (or under `data_name`), with or without gnuplot.
std::optional<std::string> write_plot(const Plot& plot, const std::filesystem::path& folder, const std::string& name,
                                      const std::string& data_name = {});

}  // namespace validate
