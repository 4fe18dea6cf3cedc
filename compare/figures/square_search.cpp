#include "compare/figures/square_search.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compare/process/atoms_curves.hpp"
#include "compare/study/levels.hpp"

namespace validate {
namespace {

constexpr double ripple_A = 0.5;
// A folded sheet has directions in which it costs next to nothing to move, and they take most of the evaluations, 4000
// to 7000.
constexpr double force_tolerance_eV_per_A = 1e-4;
constexpr int most_evaluations = 20000;
constexpr double shares_of_pressure[] = {0.02, 0.15, 0.4, 0.7, 1};

std::string name_of_start(int k) {
  return k == 0 ? "through smaller pressures" : k == 1 ? "at once" : fmt::format("ripples, seed {}", k);
}

AtomsPath path_of(const atomistic::Problem& square, double pressure, int k) {
  AtomsPath path{fmt::format("square-{}", k), square};
  path.problem.virials = true;
  path.problem.force_tolerance_eV_per_A = force_tolerance_eV_per_A;
  path.problem.max_evaluations = most_evaluations;
  if (k == 0) {
    path.problem.levels.clear();
    for (const double share : shares_of_pressure) path.problem.levels.push_back(share * pressure);
  }
  if (k > 1) path.problem.ripple_A = ripple_A, path.problem.ripple_seed = static_cast<unsigned>(k);
  return path;
}

Found found_of(const AtomsCurve& curve, double pressure, int k) {
  if (!curve.failure.empty()) throw Error(curve.failure_code, curve.failure);
  Found found{.start = name_of_start(k), .step = curve.steps.back()};
  for (const atomistic::Step& step : curve.steps) {
    found.evaluations += step.evaluations;
    if (step.target < 0.999 * pressure)
      found.path += fmt::format("{}{:.2f} Å at {:g} of the pressure", found.path.empty() ? "; " : ", ", step.depth_A,
                                step.target / pressure);
  }
  const double work = found.step.force_eV_per_A * found.step.conjugate_depth_A;  // pressure × volume
  found.potential_eV = found.step.energy_eV - work;
  found.left_eV = found.step.force_error_relative * work / 2;
  return found;
}

}  // namespace

PairedSquare paired_square(const Case& c, const PotentialFile& file, const PotentialCard& card) {
  const PairedSheet sheet(c, file.potential, card.card);
  PairedLoad load = pair(c, {file, card, sheet}).front();
  set_levels(c, load);
  return {sheet.sheet(), load.atoms->problem, load.find(Purpose::like_for_like)->problem, 2 * sheet.half_A()};
}

std::vector<Found> search_states(const PairedSquare& pair, double pressure_eV_per_A3, const AtomsLaunch& launch,
                                 const FigureContext& context) {
  std::vector<AtomsPath> paths;
  for (int k = 0; k < context.starts; ++k) paths.push_back(path_of(pair.atoms, pressure_eV_per_A3, k));
  const auto curves = compute_curves(launch, paths, 1, context.work, context.progress);
  std::vector<Found> all;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    if (curves[k].failure.empty() &&
        (curves[k].steps.empty() || curves[k].steps.back().target < 0.999 * pressure_eV_per_A3))
      continue;
    all.push_back(found_of(curves[k], pressure_eV_per_A3, static_cast<int>(k)));
  }
  if (all.empty()) throw Error(ExitCode::not_converged, "figure 4: no search of the atoms came to the full pressure");
  std::ranges::sort(all, {}, &Found::potential_eV);
  return all;
}

}  // namespace validate
