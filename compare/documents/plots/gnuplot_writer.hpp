// A drawing as gnuplot's text, in the one style of all figures.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/documents/plots/plot.hpp"

namespace validate {

enum class PictureFormat { svg, png, pdf };

/// ".svg".
const char* extension(PictureFormat);

struct Picture {
  PictureFormat format;
  std::filesystem::path file;
};

/// The whole script: the data once, then the same commands for each picture; a PNG has twice as many pixels as an SVG
/// has units, a PDF 0.2 mm for each. The same plot and pictures give the same text.
std::string gnuplot_script(const Plot& plot, const std::vector<Picture>& pictures);

}  // namespace validate
