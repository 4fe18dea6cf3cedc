#include "compare/documents/plots/ratio_commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

#include "compare/documents/plots/gnuplot.hpp"

namespace validate {
namespace {

constexpr std::array ratio_colours = {"#0072B2", "#D55E00", "#009E73", "#CC79A7"};

std::string block(std::size_t index, const Comparison& c) {
  std::string text = fmt::format("$ratio{} << EOD\n", index);
  for (std::size_t i = 0; i < c.depth_A.size(); ++i) {
    const auto cell = [&](const std::vector<double>& values) {
      return i < values.size() && std::isfinite(values[i]) ? fmt::format("{}", values[i]) : std::string("NaN");
    };
    fmt::format_to(std::back_inserter(text), "{} {} {} {} {}\n", c.depth_relative[i], cell(c.force_ratio),
                   cell(c.calibrated_membrane_ratio), cell(c.sheet_ratio), c.regime[i] == Regime::artefact ? 1 : 0);
  }
  return text + "EOD\n";
}

/// Points filled outside the artefact zone, open inside, joined by a line.
std::string curve(std::size_t index, int column, const char* colour, const char* dash, const std::string& title) {
  return fmt::format(
      "$ratio{0} using 1:{1} with lines lc rgb '{2}' lw 1.6 dt {3} notitle, \\\n"
      "     $ratio{0} using 1:($5 == 1 ? ${1} : NaN) with points pt 6 ps 0.8 lc rgb '{2}' notitle, \\\n"
      "     $ratio{0} using 1:($5 == 0 ? ${1} : NaN) with linespoints pt 7 ps 0.7 lc rgb '{2}' lw 1.6 dt {3} title {4}",
      index, column, colour, dash, gnuplot_quoted(title));
}

bool any_known(const std::vector<double>& values) {
  return std::ranges::any_of(values, [](double value) { return std::isfinite(value); });
}

std::string curves(std::size_t index, const Comparison& c) {
  const char* const colour = ratio_colours[index % ratio_colours.size()];
  std::string text = curve(index, 2, colour, "'_.'", c.load + ", membrane, card constants");
  if (any_known(c.calibrated_membrane_ratio))
    text += ", \\\n     " + curve(index, 3, colour, "'.'", c.load + ", membrane, calibrated law");
  if (any_known(c.sheet_ratio))
    text += ", \\\n     " + curve(index, 4, colour, "1", c.load + ", sheet, calibrated law");
  return text;
}

}  // namespace

std::string ratio_commands(const Result& result) {
  std::string text, plot;
  for (std::size_t i = 0; i < result.comparisons.size(); ++i) {
    if (result.comparisons[i].depth_A.empty()) continue;
    text += block(i, result.comparisons[i]);
    plot += (plot.empty() ? "plot " : ", \\\n     ") + curves(i, result.comparisons[i]);
  }
  if (plot.empty()) return {};
  const Case& c = result.resolved;
  const auto judged = result.agreement ? result.agreement->window : std::array{c.window.at(0), c.window.at(1)};
  return text +
         fmt::format(
             "set object rectangle from graph 0,first {0} to graph 1,first {1} fc rgb '#009E73' fs solid "
             "0.12 "
             "noborder behind\n"
             "set arrow from {2},graph 0 to {2},graph 1 nohead lc rgb '#888888' lw 1 dt 3\n"
             "set arrow from {3},graph 0 to {3},graph 1 nohead lc rgb '#888888' lw 1 dt 3\n"
             "set xlabel 'depth / effective radius'\nset ylabel 'force: atoms / continuum'\n"
             "set yrange [0.7:1.5]\nset xrange [0:*]\n"
             "set border 3 lw 1\nset tics nomirror out\nset grid lc rgb '#e4e4e4' lw 1 lt 1\n"
             "set key inside right top Left reverse samplen 2 font ',10'\n",
             1 - c.tolerance, 1 + c.tolerance, judged[0], judged[1]) +
         plot + "\n";
}

}  // namespace validate
