#include "compare/documents/plots/scan_commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "compare/base/units.hpp"
#include "compare/documents/plots/gnuplot.hpp"

namespace validate {
namespace {

constexpr std::array colours = {"#0072B2", "#D55E00", "#009E73", "#CC79A7"};

/// Depths of drums are read in nm.
bool in_nm(const std::vector<NamedScan>& scans) {
  return std::ranges::any_of(scans, [](const NamedScan& s) { return s.scan.depth_max_A.back() > 100; });
}

std::string blocks(const std::vector<NamedScan>& scans, double depth_factor) {
  std::string text;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const WindowScan& scan = scans[i].scan;
    fmt::format_to(std::back_inserter(text), "$scan{} << EOD\n", i);
    for (std::size_t k = 0; k < scan.depth_max_A.size(); ++k)
      fmt::format_to(std::back_inserter(text), "{} {} {}\n", depth_factor * scan.depth_max_A[k],
                     N_per_m_per_eV_per_A2 * scan.Eh_eV_per_A2[k],
                     N_per_m_per_eV_per_A2 * scan.pretension_eV_per_A2[k]);
    text += "EOD\n";
  }
  return text;
}

std::string panel(const std::vector<NamedScan>& scans, int column, const char* label, double NamedScan::*known) {
  std::string text = fmt::format("set ylabel '{}'\nplot ", label);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const char* const colour = colours[i % colours.size()];
    fmt::format_to(std::back_inserter(text),
                   "{}$scan{} using 1:{} with linespoints lc rgb '{}' pt 7 ps 0.6 lw 1.5 title {}",
                   i ? ", \\\n     " : "", i, column, colour, gnuplot_quoted(scans[i].name));
    if (std::isfinite(scans[i].*known))
      fmt::format_to(std::back_inserter(text), ", \\\n     {} with lines lc rgb '{}' lw 1 dt 2 notitle",
                     N_per_m_per_eV_per_A2 * scans[i].*known, colour);
  }
  return text + "\n";
}

}  // namespace

std::string scan_commands(const std::vector<NamedScan>& scans) {
  const bool nm = in_nm(scans);
  std::string text = blocks(scans, nm ? 0.1 : 1);
  text += fmt::format(
      "set multiplot layout 1,2\n"
      "set xlabel 'largest depth fitted ({})'\n"
      "set border 3 lw 1\nset tics nomirror out\nset grid lc rgb '#e4e4e4' lw 1 lt 1\n"
      "set offsets graph 0.05, graph 0.05, graph 0.08, graph 0.08\n"
      "set key outside above center Left reverse samplen 2 font ',9' maxrows 2\n",
      nm ? "nm" : "Å");
  text += panel(scans, 2, "E·h (N/m)", &NamedScan::Eh_known_eV_per_A2);
  text += panel(scans, 3, "pretension (N/m)", &NamedScan::pretension_known_eV_per_A2);
  return text + "unset multiplot\n";
}

std::string scan_commands(const Result& result) {
  std::vector<NamedScan> scans;
  for (const Run& run : result.runs) {
    if (run.scan.depth_max_A.size() < 2 || run.constants == Constants::paper) continue;  // one window is no scan
    const bool atoms = run.model == Model::atomistic;
    if (run.model == Model::membrane && run.constants == Constants::calibrated) continue;
    scans.push_back({fmt::format("{}, {}", atoms ? "atoms" : to_string(run.model), run.load), run.scan,
                     run.Eh_eV_per_A2, run.pretension_eV_per_A2});
  }
  return scans.empty() ? "" : scan_commands(scans);
}

}  // namespace validate
