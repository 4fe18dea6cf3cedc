#include "compare/documents/plots/gnuplot_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "compare/documents/plots/gnuplot_maps.hpp"

namespace validate {
namespace {

std::string number(double value) { return std::isfinite(value) ? fmt::format("{:.7g}", value) : "NaN"; }

std::string block(const PlotCurve& curve) {
  std::string text;
  const std::vector<double>& third = curve.value.empty() ? curve.y_high : curve.value;
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    text += number(curve.x[i]) + " " + number(curve.y[i]) + (third.empty() ? "" : " " + number(third[i])) + "\n";
    if (curve.strokes && i % 2 == 1) text += "\n\n";
  }
  return text;
}

/// Boxes of one of the shares, upon those before it of the same sign.
std::string block(const std::vector<StackedBars>& all, std::size_t which) {
  constexpr double half_width = 0.35;
  std::string text;
  for (std::size_t i = 0; i < all[which].y.size(); ++i) {
    const double height = all[which].y[i];
    if (!std::isfinite(height)) continue;
    double base = 0;
    for (std::size_t k = 0; k < which; ++k)
      if (std::isfinite(all[k].y[i]) && (all[k].y[i] < 0) == (height < 0)) base += all[k].y[i];
    const auto [low, high] = std::minmax({base, base + height});
    const auto x = static_cast<double>(i);
    fmt::format_to(std::back_inserter(text), "{:g} {:.6g} {:g} {:g} {:.6g} {:.6g}\n", x, base + height, x - half_width,
                   x + half_width, low, high);
  }
  return text;
}

}  // namespace

std::string curve_block(std::size_t panel, std::size_t curve) { return fmt::format("$p{}c{}", panel, curve); }
std::string map_block(std::size_t panel, std::size_t map) { return fmt::format("$p{}m{}", panel, map); }
std::string bar_block(std::size_t panel, std::size_t bars) { return fmt::format("$p{}b{}", panel, bars); }

std::string gnuplot_data(const Plot& plot) {
  std::string text;
  const auto add = [&](const std::string& name, const std::string& rows) {
    text += name + " << EOD\n" + rows + "EOD\n";
  };
  for (std::size_t p = 0; p < plot.panels.size(); ++p) {
    const Panel& panel = plot.panels[p];
    for (std::size_t m = 0; m < panel.maps.size(); ++m) add(map_block(p, m), map_rows(panel, panel.maps[m]));
    for (std::size_t b = 0; b < panel.bars.size(); ++b) add(bar_block(p, b), block(panel.bars, b));
    for (std::size_t c = 0; c < panel.curves.size(); ++c) add(curve_block(p, c), block(panel.curves[c]));
  }
  return text;
}

}  // namespace validate
