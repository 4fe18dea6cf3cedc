#include "compare/study/round_membrane.hpp"

#include <algorithm>
#include <cmath>

#include "membrane/laws/cauchy.hpp"
#include "membrane/meridian/sheet.hpp"

namespace validate {
namespace {

namespace meridian = membrane::axisymmetric;

const Run* shown_membrane(const Result& result) {
  for (const Constants constants : {Constants::card, Constants::given})
    for (const Run& run : result.runs)
      if (run.model == Model::membrane && run.constants == constants &&
          (run.load == result.resolved.judged_load || constants == Constants::given))
        return &run;
  return nullptr;
}

/// Larger principal Cauchy force on a circle.
double larger_force(const membrane::StVenantKirchhoff& law, double pretension, const meridian::SheetPoint& point) {
  const double offset = (1 - law.nu) * pretension / law.sheet_modulus_eV_per_A2;
  const membrane::Voigt force = membrane::cauchy_force(law, membrane::Voigt(point.radial_strain, point.hoop_strain, 0),
                                                       membrane::Voigt(offset, offset, 0), true);
  return std::max(force[0], force[1]);
}

meridian::Load round_load(const Run& run) {
  if (run.load == "sphere") return meridian::SphereLoad{run.tip_A};
  if (run.tip_A > 0) return meridian::DiscLoad{run.tip_A};
  return meridian::PointLoad{};
}

/// The membrane's circles at the deepest usable depth of a run.
std::vector<meridian::SheetPoint> circles(const Run& run, const membrane::StVenantKirchhoff& law) {
  meridian::SheetProblem problem;
  problem.radius_A = run.a_A;
  problem.law = law;
  problem.pretension_eV_per_A2 = run.pretension_eV_per_A2;
  problem.load = round_load(run);
  for (const std::size_t i : usable_points(run)) problem.levels.push_back(run.conjugate_depth_A[i]);
  std::vector<meridian::SheetPoint> points;
  meridian::solve(problem, [&](const meridian::SheetStep& step) {
    if (step.converged) points = step.points;
    return step.converged;
  });
  return points;
}

}  // namespace

std::optional<RoundField> deepest_round_field(const Result& result) {
  const Run* run = shown_membrane(result);
  if (!run || usable_points(*run).empty() || !std::isfinite(run->Eh_eV_per_A2)) return std::nullopt;
  const membrane::StVenantKirchhoff law{run->Eh_eV_per_A2, run->nu};
  RoundField field{.load = run->load, .tip_A = run->tip_A, .radius_A = {}, .larger_force_eV_per_A2 = {}};
  for (const meridian::SheetPoint& point : circles(*run, law)) {
    field.radius_A.push_back(point.radius_A + point.displacement_A);
    field.larger_force_eV_per_A2.push_back(larger_force(law, run->pretension_eV_per_A2, point));
  }
  if (field.radius_A.empty()) return std::nullopt;
  return field;
}

}  // namespace validate
