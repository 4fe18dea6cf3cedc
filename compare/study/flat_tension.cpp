#include "compare/study/flat_tension.hpp"

#include <fmt/core.h>

#include <cmath>

#include "compare/base/units.hpp"
#include "compare/process/atoms_curves.hpp"

namespace validate {
namespace {

/// First Piola–Kirchhoff, as a dead force is counted.
double tension_at(double strain, const PotentialCard& card) {
  const double plain = (card.card.C11_eV_per_A2 + card.card.C12_eV_per_A2) * strain;
  const double second = card.law ? card.law->law({strain, strain, 0}).force_eV_per_A2[0] : plain;
  return std::sqrt(1 + 2 * strain) * second;
}

/// A path of one level, so shallow that nothing is stretched by it.
AtomsPath nearly_flat(const PairedLoad& load, const char* name, double tension) {
  constexpr double depth_A = 0.02;
  AtomsPath path{.name = name, .problem = load.atoms->problem};
  path.problem.load = atomistic::DiscLoad{load.atoms->run.tip_A > 0 ? load.atoms->run.tip_A : 3.0};
  path.problem.control = atomistic::Control::conjugate_depth;
  path.problem.levels = {depth_A};
  path.problem.unload = false;
  path.problem.rim_tension_eV_per_A2 = tension;
  return path;
}

/// Two flat sheets under different tensions, settled: strain inside and what is missing there of the applied tension.
struct Flat {
  double applied = 0, strain = 0, inside = 0;
  double edge(double radius_A) const { return (applied - inside) * radius_A; }
};

/// The line's force is τ + K e, e the rim's stretch less one, which in a flat sheet is that inside.
membrane::EdgeElasticity edge_of(const Flat& one, const Flat& two, double radius_A) {
  const auto stretched = [](const Flat& flat) { return std::sqrt(1 + 2 * flat.strain) - 1; };
  const double stiffness = (two.edge(radius_A) - one.edge(radius_A)) / (stretched(two) - stretched(one));
  return {one.edge(radius_A) - stiffness * stretched(one), stiffness};
}

}  // namespace

double strain_inside(const atomistic::Sheet& sheet, const Eigen::VectorXd& positions) {
  constexpr double from = 0.2, to = 0.6;
  double sum = 0, count = 0;
  for (const auto& [i, j] : sheet.bonds) {
    const double r = sheet.position(i).head<2>().norm() / sheet.radius_A;
    if (r < from || r > to) continue;
    const Eigen::Vector3d flat = sheet.position(i) - sheet.position(j);
    sum += (positions.segment<3>(3 * i) - positions.segment<3>(3 * j)).squaredNorm() / flat.squaredNorm();
    count += 1;
  }
  return (sum / count - 1) / 2;
}

bool measure_flat_tension(std::vector<PairedLoad>& loads, const PotentialCard& card, const StudyOptions& options,
                          StudyOutcome& outcome, Progress& progress) {
  constexpr double more = 0.005;  // of E·h: the second sheet's tension beyond the first's
  const atomistic::Sheet& sheet = *outcome.sheet;
  const double applied = loads.front().atoms->problem.rim_tension_eV_per_A2,
               radius = outcome.result.sheet->effective_radius_A,
               more_applied = applied + more * card.card.sheet_modulus_eV_per_A2();
  const int ranks = options.ranks > 0 ? options.ranks : useful_ranks(options.launch, sheet.atoms(), 2);
  const auto curves = compute_curves(
      options.launch,
      {nearly_flat(loads.front(), "flat", applied), nearly_flat(loads.front(), "flat-taut", more_applied)}, ranks,
      options.folder / "work", progress);
  std::vector<Flat> flat = {{.applied = applied}, {.applied = more_applied}};
  for (std::size_t k = 0; k < curves.size(); ++k) {
    if (!curves[k].failure.empty() || curves[k].steps.empty()) {
      outcome.failure = curves[k].failure.empty() ? "the flat sheet did not settle" : curves[k].failure;
      outcome.failure_code = curves[k].failure_code;
      return false;
    }
    flat[k].strain = strain_inside(sheet, curves[k].steps.back().positions);
    flat[k].inside = tension_at(flat[k].strain, card);
  }
  const membrane::EdgeElasticity edge = edge_of(flat[0], flat[1], radius);
  outcome.result.sheet->flat_tension_eV_per_A2 = flat[0].inside;
  outcome.result.sheet->edge_stress_eV_per_A = edge.stress_eV_per_A;
  outcome.result.sheet->edge_stiffness_eV_per_A = edge.stiffness_eV_per_A;
  progress.say(
      fmt::format("flat sheet: {:.4g} N/m inside, {:.4g} N/m from the rim's force; the free edge's stress is {:.3f} "
                  "eV/Å, its stiffness {:.3g} eV/Å",
                  flat[0].inside * N_per_m_per_eV_per_A2, applied * N_per_m_per_eV_per_A2, edge.stress_eV_per_A,
                  edge.stiffness_eV_per_A));
  for (PairedLoad& load : loads) {
    load.atoms->run.rim_tension_eV_per_A2 = flat[0].inside;
    for (ContinuumExperiment& e : load.continua) {
      e.run.rim_tension_eV_per_A2 = flat[0].inside;
      // The stiffness is that of a flat sheet, where the edge's strain and the tension go together: it also holds how
      // far the lattice ends beyond its rim, and says nothing of a rim that is drawn in while the tension rises.
      e.problem.edge = {flat[0].edge(radius), 0};
    }
  }
  return true;
}

}  // namespace validate
