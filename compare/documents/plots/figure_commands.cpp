#include "compare/documents/plots/figure_commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

#include "compare/documents/plots/gnuplot.hpp"
#include "compare/fitting/curve.hpp"
#include "compare/fitting/models/eq16.hpp"

namespace validate {

namespace {

using Points = std::vector<std::array<double, 2>>;  // depth (Å), force (eV/Å)

struct Series {
  Points points;
  std::string title, style;  // style: gnuplot's, behind "with"
};

struct LoadStyle {
  std::string colour;
  int filled, open;  // gnuplot point types of the atoms outside and inside the artefact zone
};

// Colours that colour-blind readers tell apart (Okabe and Ito); one per load, in the order of the runs.
LoadStyle style_of(std::size_t load) {
  static const std::array<LoadStyle, 4> styles = {
      {{"#0072B2", 7, 6}, {"#D55E00", 5, 4}, {"#009E73", 9, 8}, {"#CC79A7", 13, 12}}};
  return styles[load % styles.size()];
}

std::vector<std::string> loads_of(const Result& result) {
  std::vector<std::string> loads;
  for (const Run& run : result.runs) {
    if (std::ranges::find(loads, run.load) == loads.end()) loads.push_back(run.load);
  }
  return loads;
}

Points usable_curve(const Run& run) {
  Points points;
  for (const std::size_t i : usable_points(run)) points.push_back({run.depth_A[i], run.force_eV_per_A[i]});
  return points;
}

// Dense enough to look smooth, through the computed points as the comparison interpolates them. It starts at the first
// of them: nothing is known below.
Points smooth_curve(const Run& run) {
  Points points;
  const Curve curve(run);
  const int pieces = 200;
  for (int i = 0; i <= pieces; ++i) {
    const double depth = std::lerp(curve.lowest_A(), curve.highest_A(), static_cast<double>(i) / pieces);
    if (const auto force = curve.at(depth)) points.push_back({depth, *force});
  }
  return points;
}

Points artefact_points(const Run& run) {
  Points points;
  for (std::size_t i = 0; i < run.artefact.size(); ++i) {
    if (run.artefact[i] && run.converged[i]) points.push_back({run.depth_A[i], run.force_eV_per_A[i]});
  }
  return points;
}

// The sheet solid, membranes thin: dash-dotted, dashed with the paper's constants. A calibrated membrane is in the
// ratios.
void add_continuum(std::vector<Series>& all, const Run& run, const LoadStyle& style) {
  if (usable_points(run).size() < 2) return;
  const bool sheet = run.model == Model::sheet, paper = run.constants == Constants::paper;
  if (!sheet && run.constants == Constants::calibrated) return;
  all.push_back({smooth_curve(run),
                 sheet ? fmt::format("sheet, {}, calibrated law with bending", run.load)
                       : fmt::format("membrane, {}, {} constants", run.load, to_string(run.constants)),
                 fmt::format("lines lc rgb '{}' lw {} dt {}", style.colour, sheet ? 2.6 : 1.3,
                             paper   ? "'-'"
                             : sheet ? "1"
                                     : "'_.'")});
}

void add_atoms(std::vector<Series>& all, const Run& run, const LoadStyle& style, double artefact_bond_A) {
  const auto markers = [&](int type) { return fmt::format("points lc rgb '{}' pt {} ps 1", style.colour, type); };
  if (const Points points = usable_curve(run); !points.empty()) {
    all.push_back({points, fmt::format("atoms, {}", run.load), markers(style.filled)});
  }
  if (const Points points = artefact_points(run); !points.empty()) {
    all.push_back({points, fmt::format("atoms, {}, bond ≥ {:.2f} Å", run.load, artefact_bond_A), markers(style.open)});
  }
}

double largest_depth(const Result& result) {
  double largest = 0;
  for (const Run& run : result.runs) {
    for (const double depth : run.depth_A) largest = std::max(largest, depth);
  }
  return largest;
}

double largest_force(const std::vector<Series>& all) {
  double largest = 0;
  for (const Series& series : all) {
    for (const auto& [depth, force] : series.points) largest = std::max(largest, force);
  }
  return largest;
}

// Inside, top left, where force curves leave room; beside the plot if one passes through there after all.
std::string legend_place(const std::vector<Series>& all, double depth, double force) {
  const auto in_the_corner = [&](const std::array<double, 2>& point) {
    return point[0] < 0.5 * depth && point[1] > 0.5 * force;
  };
  const bool taken =
      std::ranges::any_of(all, [&](const Series& s) { return std::ranges::any_of(s.points, in_the_corner); });
  return taken ? "outside right center" : "inside left top";
}

// The closed form with the constants of the like-for-like membrane, or of whatever membrane there is.
void add_eq16(std::vector<Series>& all, const Result& result) {
  const auto membrane = [&](Constants constants) {
    return std::ranges::find_if(
        result.runs, [&](const Run& run) { return run.model == Model::membrane && run.constants == constants; });
  };
  for (const Constants constants : {Constants::card, Constants::given, Constants::paper}) {
    const auto run = membrane(constants);
    if (run == result.runs.end()) continue;
    const Eq16 closed_form{run->a_A, run->nu};
    const double end = largest_depth(result);
    Points points;
    for (int i = 0; i <= 200; ++i) {
      const double depth = end * i / 200;
      points.push_back({depth, closed_form.force(depth, run->Eh_eV_per_A2, run->pretension_eV_per_A2)});
    }
    all.push_back({points, fmt::format("Eq. 16, {} constants", to_string(constants)), "lines lc rgb 'black' lw 0.8"});
    return;
  }
}

std::vector<Series> all_series(const Result& result) {
  const std::vector<std::string> loads = loads_of(result);
  const auto style = [&](const Run& run) {
    return style_of(static_cast<std::size_t>(std::ranges::find(loads, run.load) - loads.begin()));
  };
  std::vector<Series> all;
  for (const Run& run : result.runs) {
    if (run.model == Model::atomistic) add_atoms(all, run, style(run), artefact_bond_of(result));
  }
  for (const Run& run : result.runs) {
    if (run.model != Model::atomistic) add_continuum(all, run, style(run));
  }
  return all;
}

struct ArtefactZone {
  double from_A;
  std::string load, colour;
};

// Where a load's longest bond first reached the artefact length.
std::vector<ArtefactZone> artefact_zones(const Result& result) {
  std::vector<ArtefactZone> zones;
  const std::vector<std::string> loads = loads_of(result);
  for (const Run& run : result.runs) {
    const std::optional<std::size_t> first = first_artefact(run);
    if (!first) continue;
    const auto load = static_cast<std::size_t>(std::ranges::find(loads, run.load) - loads.begin());
    zones.push_back({run.depth_A[*first], run.load, style_of(load).colour});
  }
  return zones;
}

// A band in the load's colour from there on.
std::string zone_commands(const std::vector<ArtefactZone>& zones) {
  std::string text;
  for (const ArtefactZone& zone : zones) {
    fmt::format_to(std::back_inserter(text),
                   "set object rectangle from {0},graph 0 to graph 1,graph 1 fc rgb '{1}' fs solid 0.10 noborder "
                   "behind\n"
                   "set arrow from {0},graph 0 to {0},graph 1 nohead lc rgb '{1}' lw 1 dt 2 back\n",
                   zone.from_A, zone.colour);
  }
  return text;
}

std::string title_of(const Result& result) {
  const bool atoms = std::ranges::any_of(result.runs, [](const Run& r) { return r.model == Model::atomistic; });
  const double radius = result.resolved.radius_A;
  const std::string size = radius < 1000 ? fmt::format("R = {:g} Å", radius) : fmt::format("R = {:g} µm", radius / 1e4);
  const std::string what = atoms || result.card ? result.resolved.potential : "membrane";
  return fmt::format("{}, {}, tip radius {:g} Å", what, size, result.resolved.tip_radius_A);
}

std::string data_blocks(const std::vector<Series>& all) {
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i) {
    fmt::format_to(std::back_inserter(text), "$series{} << EOD\n", i);
    for (const auto& [depth, force] : all[i].points) {
      fmt::format_to(std::back_inserter(text), "{} {}\n", depth, force);
    }
    text += "EOD\n";
  }
  return text;
}

}  // namespace

std::string figure_commands(const Result& result) {
  std::vector<Series> all = all_series(result);
  const double force = largest_force(all), depth = largest_depth(result);
  add_eq16(all, result);

  std::string text = fmt::format(
      "set title {} font ',14'\n"
      "set xlabel 'depth (Å)'\n"
      "set ylabel 'force (eV/Å)'\n"
      "set xrange [0:{}]\n"
      "set yrange [0:{}]\n"
      "set border 3 lw 1\n"
      "set tics nomirror out\n"
      "set grid lc rgb '#e4e4e4' lw 1 lt 1\n"
      "set key {} Left reverse samplen 2.5 spacing 1.25 font ',11'\n",
      gnuplot_quoted(title_of(result)), depth > 0 ? 1.04 * depth : 1, force > 0 ? 1.05 * force : 1,
      legend_place(all, depth, force));
  const std::vector<ArtefactZone> zones = artefact_zones(result);
  std::vector<std::string> clauses;
  for (std::size_t i = 0; i < all.size(); ++i) {
    clauses.push_back(
        fmt::format("$series{} using 1:2 with {} title {}", i, all[i].style, gnuplot_quoted(all[i].title)));
  }
  for (const ArtefactZone& zone : zones) {  // the bands' entries in the legend
    clauses.push_back(fmt::format("NaN with boxes fs solid 0.25 lc rgb '{}' title {}", zone.colour,
                                  gnuplot_quoted(fmt::format("artefact zone, {}", zone.load))));
  }
  if (clauses.empty()) clauses.push_back("NaN notitle");
  text += zone_commands(zones) + fmt::format("plot {}", fmt::join(clauses, ", \\\n     "));
  return data_blocks(all) + text + "\n";
}

}  // namespace validate
