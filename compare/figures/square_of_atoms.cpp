#include "compare/figures/square_of_atoms.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <ranges>

#include "compare/base/paper.hpp"
#include "compare/base/paths.hpp"
#include "compare/documents/plots/sheet_maps.hpp"
#include "compare/figures/square.hpp"
#include "compare/figures/square_search.hpp"
#include "compare/figures/undulation.hpp"
#include "compare/figures/virial_field.hpp"
#include "compare/potential/potential_card.hpp"

namespace validate {
namespace {

using paper::pressure_eV_per_A3;
using paper::side_A;
constexpr int cells = 20;      // of the virials' field: 11 Å, some 45 atoms
constexpr double line_A = 11;  // from a side to the line on which waves are looked for

Case square_case(const std::string& potential) {
  Case c = bulge_defaults();  // the paper's square
  c.extent = Extent::full;
  c.potential = potential;
  return c;
}

/// The membrane's state at a place, 0 where it is taut: that of the triangle whose middle is nearest.
double state_at(const SheetPicture& membrane, const Eigen::Vector2d& place) {
  const auto distance = [&](std::size_t t) { return (middle_of(membrane, t, SeenOver::flat) - place).squaredNorm(); };
  const std::vector<double>& state = column(membrane.triangles, "state");
  return state[*std::ranges::min_element(std::views::iota(std::size_t{0}, state.size()), {}, distance)];
}

Panel virial_panel(const std::string& title, const std::vector<VirialCell>& field, const SheetPicture& membrane) {
  Panel panel = square_panel(title, "eV/Å²");
  TriangleMap map{.name = title, .key = "smaller_principal_force_eV_per_A2", .corners = {}, .value = {}};
  for (const VirialCell& cell : field)
    for (const int third : {2, 3}) {
      map.corners.push_back({cell.corners_A[0], cell.corners_A[third - 1], cell.corners_A[third]});
      map.value.push_back(cell.smaller_eV_per_A2);
    }
  panel.maps.push_back(std::move(map));
  panel.curves.push_back(wrinkled_outline(membrane, SeenOver::flat));
  return panel;
}

/// Where the four sides are in their plane: folds show as notches.
Panel edges_panel(const std::string& name, const PairedSquare& pair, const Found& found, const SheetPicture& membrane) {
  Panel panel = seen_from_above("sides, seen from above", 120);
  panel.legend = Legend::centre;
  PlotCurve atoms{.name = name + ", atoms", .x = {}, .y = {}, .colour = colour_of_atoms};
  atoms.points = Points{.size = 0.25};
  for (int i = 0; i < pair.sheet.free_atoms; ++i) {
    if (!pair.sheet.slides[static_cast<std::size_t>(i)]) continue;
    atoms.x.push_back(found.step.positions[3 * i]);
    atoms.y.push_back(found.step.positions[3 * i + 1]);
  }
  PlotCurve continuum{.name = "membrane", .x = {}, .y = {}, .colour = colour_of_membrane};
  continuum.points = Points{.size = 0.35, .open = true};
  for (const auto& [edge, nodes] : membrane.mesh.edges)
    for (const int n : nodes) {
      const Eigen::Vector2d place = place_of(membrane, n, SeenOver::deformed);
      continuum.x.push_back(place.x());
      continuum.y.push_back(place.y());
    }
  panel.curves = {continuum, atoms};
  return panel;
}

/// A line along one of the four sides, line_A inside it in the flat sheet: place along it, and where the sheet is in
/// the direction of the line's mean normal. In each stretch of 5 Å a straight line through the rows of atoms nearby is
/// read at line_A, so that the slope of the wall does not show as waves.
CrossSection along_side(const PairedSquare& pair, const Eigen::VectorXd& positions, int side) {
  constexpr double stretch_A = 5, reach_A = 4;
  const int across = side % 2, along = 1 - across;
  const double at = (side < 2 ? 1 : -1) * (pair.size_A[across] / 2 - line_A);
  const auto near = [&](int i) { return std::abs(pair.sheet.position(i)[across] - at) < reach_A; };
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (int i = 0; i < pair.sheet.free_atoms; ++i)
    if (near(i)) normal += area_of_atom(pair.sheet, positions, i);
  normal.normalize();
  const int stretches = static_cast<int>(pair.size_A[along] / stretch_A);
  struct Sums {
    double n = 0, d = 0, u = 0, dd = 0, du = 0;
  };
  std::vector<Sums> sums(static_cast<std::size_t>(stretches));
  for (int i = 0; i < pair.sheet.free_atoms; ++i) {
    const int k = static_cast<int>(std::floor((pair.sheet.position(i)[along] + pair.size_A[along] / 2) / stretch_A));
    if (!near(i) || k < 0 || k >= stretches) continue;
    const double d = pair.sheet.position(i)[across] - at, u = normal.dot(positions.segment<3>(3 * i));
    Sums& sum = sums[static_cast<std::size_t>(k)];
    sum.n += 1, sum.d += d, sum.u += u, sum.dd += d * d, sum.du += d * u;
  }
  CrossSection line;
  for (int k = 0; k < stretches; ++k) {
    const Sums& sum = sums[static_cast<std::size_t>(k)];
    const double determinant = sum.n * sum.dd - sum.d * sum.d;
    if (!(determinant > 1e-9)) continue;
    line.x_A.push_back((k + 0.5) * stretch_A - pair.size_A[along] / 2);
    line.z_A.push_back((sum.u * sum.dd - sum.d * sum.du) / determinant);
  }
  const double mean = std::accumulate(line.z_A.begin(), line.z_A.end(), 0.0) / static_cast<double>(line.z_A.size());
  for (double& z : line.z_A) z -= mean;
  return line;
}

constexpr std::array side_names = {"right", "top", "left", "bottom"};

Panel sides_panel(const PairedSquare& pair, const Found& found) {
  Panel panel{.title = fmt::format("atoms along the sides, {:g} Å inside: out of the mean plane there", line_A),
              .x = {.label = "place along the side in the flat sheet", .unit = "Å", .key = "place_A"},
              .y = {.label = "along the mean normal", .unit = "Å", .key = "out_of_plane_A"},
              .legend = Legend::right_top};
  panel.x.low = -112, panel.x.high = 112;
  for (std::size_t side = 0; side < side_names.size(); ++side) {
    const CrossSection line = along_side(pair, found.step.positions, static_cast<int>(side));
    panel.curves.push_back({.name = side_names[side],
                            .x = line.x_A,
                            .y = line.z_A,
                            .colour = nth_colour(side),
                            .line = Line{.width = 1.2}});
  }
  return panel;
}

/// How far the atoms of an edge have come in at most, along its normal; a rotation of the whole sheet is taken out
/// first.
double pull_in(const PairedSquare& pair, const Eigen::VectorXd& positions) {
  double sine = 0, cosine = 0;
  const auto flat = [&](int i) -> Eigen::Vector2d { return pair.sheet.position(i).head<2>(); };
  for (int i = 0; i < pair.sheet.free_atoms; ++i) {
    const Eigen::Vector2d X = flat(i), x = positions.segment<2>(3 * i);
    cosine += X.dot(x);
    sine += X.x() * x.y() - X.y() * x.x();
  }
  const double angle = std::atan2(sine, cosine);
  double largest = 0;
  for (int i = 0; i < pair.sheet.free_atoms; ++i) {
    if (!pair.sheet.slides[static_cast<std::size_t>(i)]) continue;
    const Eigen::Vector2d X = flat(i), x = Eigen::Rotation2Dd(-angle) * Eigen::Vector2d(positions.segment<2>(3 * i));
    const int across = std::abs(X.x()) > std::abs(X.y()) ? 0 : 1;
    largest = std::max(largest, (X[across] - x[across]) * (X[across] > 0 ? 1 : -1));
  }
  return largest;
}

/// The deepest fold along the sides: from the highest point of a line to its lowest.
double deepest_fold(const PairedSquare& pair, const Eigen::VectorXd& positions) {
  double deepest = 0;
  for (int side = 0; side < 4; ++side) {
    const auto [low, high] = std::ranges::minmax(along_side(pair, positions, side).z_A);
    deepest = std::max(deepest, high - low);
  }
  return deepest;
}

Undulation mean_undulation(const PairedSquare& pair, const Eigen::VectorXd& positions) {
  Undulation mean;
  for (int side = 0; side < 4; ++side) {
    const CrossSection line = along_side(pair, positions, side);
    const Undulation one = undulation_of(line.x_A, line.z_A);
    mean.amplitude_A += one.amplitude_A / 4;
    mean.wavelength_A += one.wavelength_A / 4;
  }
  return mean;
}

/// Atoms wrinkle in a cell where they carry no tension across: less than a hundredth of the largest smaller force.
struct Zones {
  double wrinkled_share = 0, same_share = 0;           ///< of the cells
  double inside_eV_per_A2 = 0, outside_eV_per_A2 = 0;  ///< mean smaller force in the membrane's wrinkled and taut zones
  double least_eV_per_A2 = 0;
};

Zones zones_of(const std::vector<VirialCell>& field, const SheetPicture& membrane) {
  Zones zones;
  double largest = 0, inside = 0, outside = 0;
  for (const VirialCell& cell : field) largest = std::max(largest, cell.smaller_eV_per_A2);
  for (const VirialCell& cell : field) {
    const bool by_membrane = state_at(membrane, cell.middle_A) != 0;
    const bool by_atoms = cell.smaller_eV_per_A2 < 0.01 * largest;
    zones.wrinkled_share += by_atoms;
    zones.same_share += by_atoms == by_membrane;
    (by_membrane ? inside : outside) += 1;
    (by_membrane ? zones.inside_eV_per_A2 : zones.outside_eV_per_A2) += cell.smaller_eV_per_A2;
    zones.least_eV_per_A2 = std::min(zones.least_eV_per_A2, cell.smaller_eV_per_A2);
  }
  const double all = static_cast<double>(field.size());
  zones.wrinkled_share /= all;
  zones.same_share /= all;
  zones.inside_eV_per_A2 /= std::max(inside, 1.0);
  zones.outside_eV_per_A2 /= std::max(outside, 1.0);
  return zones;
}

void add_numbers(PaperFigure& figure, const std::string& name, const PairedSquare& pair, const Found& found,
                 const SheetPicture& membrane, const std::vector<VirialCell>& field) {
  const std::string source = "membrane with the card's constants";
  const Zones zones = zones_of(field, membrane);
  const auto add = [&](const std::string& what, const char* unit, double reference, double ours) {
    figure.numbers.push_back({name + " atoms: " + what, unit, source, reference, ours, 0, ""});
  };
  add("centre depth", "Å", total(membrane.totals, "depth_A"), found.step.depth_A);
  add("volume", "Å³", total(membrane.totals, "volume_A3"),
      found.step.force_eV_per_A / pressure_eV_per_A3 * found.step.conjugate_depth_A);
  add("energy minus pressure times volume", "eV",
      total(membrane.totals, "energy_eV") - pressure_eV_per_A3 * total(membrane.totals, "volume_A3"),
      found.potential_eV);
  add("mid-side pull-in", "Å", largest_pull_in_A(membrane), pull_in(pair, found.step.positions));
  add("wrinkled share", "1", total(membrane.totals, "wrinkled_area_fraction"), zones.wrinkled_share);
}

void add_remarks(PaperFigure& figure, const std::string& name, const PairedSquare& pair, const std::vector<Found>& all,
                 const SheetPicture& membrane, const std::vector<VirialCell>& field) {
  const Zones zones = zones_of(field, membrane);
  const Undulation waves = mean_undulation(pair, all.front().step.positions);
  auto& remarks = figure.remarks;
  remarks.push_back(fmt::format("{}: {} atoms; the lowest of {} states is shown ({})", name, pair.sheet.atoms(),
                                all.size(), all.front().start));
  for (const Found& f : all)
    remarks.push_back(fmt::format(
        "start '{}': energy − pV = {:.3f} eV (+{:.3f} above the lowest), depth {:.3f} Å, {} evaluations, max|f| {:.1e} "
        "eV/Å, about {:.1e} eV left{}",
        f.start, f.potential_eV, f.potential_eV - all.front().potential_eV, f.step.depth_A, f.evaluations,
        f.step.max_force_eV_per_A, f.left_eV, f.path));
  remarks.push_back(fmt::format(
      "smaller principal force of the atoms (cells of {:g} Å): mean {:.4f} eV/Å² where the membrane is wrinkled, "
      "{:.4f} where "
      "it is taut, least {:.4f}; {:.0f} % of the cells are wrinkled or taut in both",
      side_A / cells, zones.inside_eV_per_A2, zones.outside_eV_per_A2, zones.least_eV_per_A2, 100 * zones.same_share));
  remarks.push_back(
      fmt::format("waves along the sides, {:g} Å inside, out of the mean plane there: amplitude {:.2f} Å, wavelength "
                  "{:.1f} Å (means over four); "
                  "deepest fold {:.1f} Å",
                  line_A, waves.amplitude_A, waves.wavelength_A, deepest_fold(pair, all.front().step.positions)));
}

}  // namespace

void add_square_of_atoms(PaperFigure& figure, const FigureContext& context) {
  const std::string& potential = context.potentials.front();
  const std::string name = std::filesystem::path(potential).stem().string();
  const PotentialFile file = read_potential(potential, inputs_folder() / "potentials", "--potential");
  const AtomsLaunch launch{.program = atoms_program(), .launcher = {}, .cores = available_cores()};
  const PotentialCard card = potential_card(file, launch, card_cache(), false);
  const PairedSquare pair = paired_square(square_case(potential), file, card);
  context.progress.say(fmt::format("figure 4: {} atoms, {} starts", pair.sheet.atoms(), context.starts));
  // Over a thickness of 1 Å stresses are membrane forces.
  const SheetPicture membrane = solved_levels(pair.membrane, 1, "figure 4").back();
  const std::vector<Found> all = search_states(pair, pressure_eV_per_A3, launch, context);
  const std::vector<VirialCell> field = virial_field(pair.sheet, all.front().step, cells);
  const double most = std::ranges::max(column(membrane.triangles, "cauchy_2_eV_per_A3"));
  figure.panels.push_back(square_panel(fmt::format("membrane, {}'s E·h and ν: smaller principal force", name), "eV/Å²",
                                       membrane, "cauchy_2_eV_per_A3", "smaller_principal_force_eV_per_A2"));
  figure.panels.push_back(
      virial_panel(fmt::format("{}'s atoms: smaller principal force, by virials", name), field, membrane));
  for (Panel* panel : {&figure.panels.back(), &figure.panels.back() - 1})
    panel->scale.low = -0.2 * most, panel->scale.high = 1.1 * most;
  figure.panels.push_back(edges_panel(name, pair, all.front(), membrane));
  figure.panels.push_back(sides_panel(pair, all.front()));
  add_numbers(figure, name, pair, all.front(), membrane, field);
  add_remarks(figure, name, pair, all, membrane, field);
}

}  // namespace validate
