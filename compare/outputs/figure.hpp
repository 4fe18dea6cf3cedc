// figure.svg and figure.png: force against depth, atoms, membrane and Eq. 16 (the paper's Figure 2).
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "compare/result.hpp"

namespace compare {

/// Draws both files. A system without gnuplot gets neither: nothing is thrown and the return value says so,
/// as it says what gnuplot warned of. Throws Error (file failed) with gnuplot's message when it fails, or
/// when its PNG is empty.
std::optional<std::string> write_figure(const Result& result, const std::filesystem::path& folder);

}  // namespace compare
