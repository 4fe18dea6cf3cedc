#include "compare/documents/plots/explanation_bars.hpp"

#include <fmt/format.h>

#include <cmath>

namespace validate {

const std::vector<Share>& shares() {
  static const std::vector<Share> all = {{"radii of clamp and tip", &Explanation::geometry, Colour::grey},
                                         {"bending", &Explanation::bending, Colour::blue},
                                         {"large-strain response", &Explanation::large_strain, Colour::vermilion},
                                         {"anisotropy", &Explanation::anisotropy, Colour::purple},
                                         {"remainder", &Explanation::remainder, Colour::black}};
  return all;
}

std::vector<double> sum_of_shares(const Explanation& e) {
  std::vector<double> sums(e.depth_A.size(), 0);
  for (const Share& share : shares())
    for (std::size_t i = 0; i < sums.size(); ++i)
      if (std::isfinite((e.*share.values)[i])) sums[i] += (e.*share.values)[i];
  return sums;
}

std::vector<std::size_t> shown_depths(std::size_t count, std::size_t most) {
  std::vector<std::size_t> shown;
  if (count <= most) {
    for (std::size_t i = 0; i < count; ++i) shown.push_back(i);
    return shown;
  }
  for (std::size_t k = 0; k < most; ++k) shown.push_back((k * (count - 1) + (most - 1) / 2) / (most - 1));
  return shown;
}

namespace {

Panel panel_of(const Explanation& e) {
  Panel panel{.title = fmt::format("{} load", e.load),
              .x = {.label = "depth / effective radius", .unit = {}, .key = "depth_relative"},
              .y = {.label = "% of the plain membrane force", .unit = {}, .key = "share_percent"},
              .legend = Legend::right_top,
              .marks = {{.along = Along::y, .at = 0}}};
  for (const Share& share : shares()) panel.bars.push_back({.name = share.name, .colour = share.colour, .y = {}});
  PlotCurve atoms{.name = "atoms",
                  .x = {},
                  .y = {},
                  .colour = Colour::green,
                  .points = Points{.marker = Marker::square, .size = 0.9}};
  const std::vector<double> sums = sum_of_shares(e);
  for (const std::size_t i : shown_depths(e.depth_A.size())) {
    panel.x.categories.push_back(fmt::format("{:.3f}", e.depth_relative[i]));
    for (std::size_t k = 0; k < shares().size(); ++k) panel.bars[k].y.push_back(100 * (e.*shares()[k].values)[i]);
    atoms.x.push_back(static_cast<double>(atoms.x.size()));
    atoms.y.push_back(100 * sums[i]);
  }
  panel.curves = {std::move(atoms)};
  return panel;
}

}  // namespace

Plot explanation_plot(const Result& result) {
  Plot plot{.columns = static_cast<int>(result.explanations.size()), .width = 1000, .height = 460};
  for (const Explanation& e : result.explanations) plot.panels.push_back(panel_of(e));
  return plot;
}

}  // namespace validate
