#include "compare/outputs/ratio_commands.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>
#include <vector>

#include "compare/outputs/gnuplot.hpp"

namespace compare {
namespace {

constexpr std::array colours = {"#0072B2", "#D55E00", "#009E73", "#CC79A7"};

std::string block(std::size_t index, const Comparison& c) {
  std::string text = fmt::format("$ratio{} << EOD\n", index);
  for (std::size_t i = 0; i < c.depth_A.size(); ++i)
    fmt::format_to(std::back_inserter(text), "{} {} {} {}\n", c.depth_relative[i], c.force_ratio[i],
                   c.energy_ratio[i], c.regime[i] == Regime::artefact ? 1 : 0);
  return text + "EOD\n";
}

std::string curves(std::size_t index, const Comparison& c) {
  const char* const colour = colours[index % colours.size()];
  const std::string artefact =
      std::isfinite(c.artefact_from_A)
          ? fmt::format(
                "     $ratio{} using 1:($4 == 1 ? $2 : NaN) with points pt 6 ps 0.8 lc rgb '{}' title {}, "
                "\\\n",
                index, colour, gnuplot_quoted("force, " + c.load + ", artefact zone"))
          : "";
  return fmt::format(
      "$ratio{0} using 1:2 with lines lc rgb '{1}' lw 1.5 notitle, \\\n"
      "     $ratio{0} using 1:($4 == 0 ? $2 : NaN) with points pt 7 ps 0.8 lc rgb '{1}' title {2}, \\\n{3}"
      "     $ratio{0} using 1:3 with lines lc rgb '{1}' lw 1.2 dt '-' title {4}",
      index, colour, gnuplot_quoted("force, " + c.load), artefact, gnuplot_quoted("energy, " + c.load));
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
  return text +
         fmt::format(
             "set object rectangle from graph 0,first {0} to graph 1,first {1} fc rgb '#009E73' fs solid "
             "0.12 "
             "noborder behind\n"
             "set arrow from {2},graph 0 to {2},graph 1 nohead lc rgb '#888888' lw 1 dt 3\n"
             "set arrow from {3},graph 0 to {3},graph 1 nohead lc rgb '#888888' lw 1 dt 3\n"
             "set xlabel 'depth / effective radius'\nset ylabel 'atoms / membrane'\n"
             "set yrange [0.6:1.6]\nset xrange [0:*]\n"
             "set border 3 lw 1\nset tics nomirror out\nset grid lc rgb '#e4e4e4' lw 1 lt 1\n"
             "set key inside right top Left reverse samplen 2 font ',10'\n",
             1 - c.tolerance, 1 + c.tolerance, c.window.at(0), c.window.at(1)) +
         plot + "\n";
}

}  // namespace compare
