#include "compare/documents/plots/fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <optional>
#include <sstream>
#include <vector>

#include "compare/base/units.hpp"
#include "compare/documents/plots/gnuplot.hpp"
#include "membrane/laws/cauchy.hpp"
#include "membrane/meridian/sheet.hpp"

namespace validate {
namespace {

namespace round = membrane::axisymmetric;

struct Map {
  std::string data, plot, title;
};

struct Atom {
  double x, y, longest_bond;
};

/// Free atoms of an extended XYZ file written by this program (outputs/extxyz).
std::vector<Atom> read_atoms(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::vector<Atom> atoms;
  std::string line;
  std::getline(in, line);
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::istringstream cells(line);
    std::string species;
    std::array<double, 7> number{};
    int clamped = 0;
    cells >> species;
    for (double& n : number) cells >> n;
    if (cells >> clamped; cells && clamped == 0) atoms.push_back({number[0], number[1], number[6]});
  }
  return atoms;
}

std::optional<Map> atoms_map(const Result& result, const std::filesystem::path& folder) {
  const std::string load = result.resolved.judged_load;
  const std::vector<Atom> atoms = read_atoms(folder / fmt::format("atoms-{}.extxyz", load));
  if (atoms.empty()) return std::nullopt;
  Map map{.data = "$atoms << EOD\n", .plot = {}, .title = {}};
  for (const Atom& a : atoms)
    fmt::format_to(std::back_inserter(map.data), "{:.2f} {:.2f} {:.4f}\n", a.x, a.y, a.longest_bond);
  map.data += "EOD\n";
  map.title = fmt::format("atoms, {} load: longest bond (Å)", load);
  map.plot = fmt::format("unset view\nplot $atoms using 1:2:3 with points pt 7 ps {:.2f} palette notitle\n",
                         std::clamp(55 / std::sqrt(static_cast<double>(atoms.size())), 0.12, 0.8));
  return map;
}

const Run* shown_membrane(const Result& result) {
  for (const Constants constants : {Constants::card, Constants::given})
    for (const Run& run : result.runs)
      if (run.model == Model::membrane && run.constants == constants &&
          (run.load == result.resolved.judged_load || constants == Constants::given))
        return &run;
  return nullptr;
}

/// Larger principal Cauchy force on a circle.
double larger_force(const membrane::StVenantKirchhoff& law, double pretension, const round::SheetPoint& point) {
  const double offset = (1 - law.nu) * pretension / law.sheet_modulus_eV_per_A2;
  const membrane::Voigt force = membrane::cauchy_force(law, membrane::Voigt(point.radial_strain, point.hoop_strain, 0),
                                                       membrane::Voigt(offset, offset, 0), true);
  return std::max(force[0], force[1]);
}

round::Load round_load(const Run& run) {
  if (run.load == "sphere") return round::SphereLoad{run.tip_A};
  if (run.tip_A > 0) return round::DiscLoad{run.tip_A};
  return round::PointLoad{};
}

/// The membrane's circles at the deepest depth of a run.
std::vector<round::SheetPoint> circles(const Run& run, const membrane::StVenantKirchhoff& law) {
  round::SheetProblem problem;
  problem.radius_A = run.a_A;
  problem.law = law;
  problem.pretension_eV_per_A2 = run.pretension_eV_per_A2;
  problem.load = round_load(run);
  for (const std::size_t i : usable_points(run)) problem.levels.push_back(run.conjugate_depth_A[i]);
  std::vector<round::SheetPoint> points;
  round::solve(problem, [&](const round::SheetStep& step) {
    if (step.converged) points = step.points;
    return step.converged;
  });
  return points;
}

std::optional<Map> membrane_map(const Result& result) {
  const Run* run = shown_membrane(result);
  if (!run || usable_points(*run).empty() || !std::isfinite(run->Eh_eV_per_A2)) return std::nullopt;
  const membrane::StVenantKirchhoff law{run->Eh_eV_per_A2, run->nu};
  const std::vector<round::SheetPoint> points = circles(*run, law);
  if (points.empty()) return std::nullopt;
  constexpr int around = 72;
  Map map{.data = "$membrane << EOD\n", .plot = {}, .title = {}};
  for (const round::SheetPoint& point : points) {
    // Under a point load the force at the centre has no bound: what is shown begins a hundredth of the radius
    // away.
    if (!(run->tip_A > 0) && point.radius_A < 0.01 * run->a_A) continue;
    const double force = N_per_m_per_eV_per_A2 * larger_force(law, run->pretension_eV_per_A2, point);
    for (int k = 0; k <= around; ++k) {
      const double angle = 2 * std::numbers::pi * k / around, r = point.radius_A + point.displacement_A;
      fmt::format_to(std::back_inserter(map.data), "{:.2f} {:.2f} {:.4f}\n", r * std::cos(angle), r * std::sin(angle),
                     force);
    }
    map.data += "\n";
  }
  map.data += "EOD\n";
  map.title = fmt::format("membrane, {} load: larger principal Cauchy force (N/m)", run->load);
  map.plot = "set view map\nset pm3d map corners2color mean\nsplot $membrane using 1:2:3 with pm3d notitle\n";
  return map;
}

}  // namespace

std::string field_commands(const Result& result, const std::filesystem::path& folder) {
  std::vector<Map> maps;
  if (auto map = atoms_map(result, folder)) maps.push_back(std::move(*map));
  if (auto map = membrane_map(result)) maps.push_back(std::move(*map));
  if (maps.empty()) return {};
  std::string text;
  for (const Map& map : maps) text += map.data;
  text += fmt::format(
      "set multiplot layout 1,{}\nset size ratio -1\nset border 0\nunset xtics\nunset ytics\n"
      "set palette defined (0 '#440154', 1 '#3b528b', 2 '#21918c', 3 '#5ec962', 4 '#fde725')\n"
      "set colorbox user origin graph 1.02, graph 0.1 size graph 0.03, graph 0.8\n",
      maps.size());
  for (const Map& map : maps) text += fmt::format("set title {}\n", gnuplot_quoted(map.title)) + map.plot;
  return text + "unset multiplot\n";
}

}  // namespace validate
