// The paper's pressurised square, and stresses of squares under pressure.
#include <algorithm>
#include <limits>

#include "compare/base/paper.hpp"
#include "compare/verify/groups.hpp"
#include "compare/verify/solved.hpp"
#include "compare/verify/square.hpp"
#include "membrane/laws/cauchy.hpp"
#include "membrane/terms/stretching.hpp"

namespace validate::verify {

using namespace membrane;

SmallerStress smaller_cauchy_force(const Problem& problem, const Step& step) {
  SmallerStress range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Triangle& triangle : mesh_of(problem).triangles) {
    const Voigt strain = strain_of(triangle, step.on_triangles().displacements);
    const Voigt force = std::visit(
        [&]<MaterialLaw L>(const L& law) { return cauchy_force(law, strain, Voigt::Zero(), problem.relaxed); },
        problem.law);
    const double smaller = principal_forces(force).smaller;
    range.least = std::min(range.least, smaller);
    range.largest = std::max(range.largest, smaller);
  }
  return range;
}

namespace {

void square(Ledger& ledger, const char* name, Extent extent, const Reference& depth, double depth_range,
            const Reference& stress, double stress_range) {
  Problem problem;
  RectangleSheet sheet = paper_square(paper::side_A);
  sheet.extent = extent;
  problem.sheet = sheet;
  problem.law = StVenantKirchhoff{paper::Eh_eV_per_A2, paper::nu};
  problem.load = PressureLoad{};
  problem.control = Control::force;
  problem.levels = {paper::pressure_eV_per_A3};
  ledger.begin(name);
  const Step step = solved_last(problem);
  ledger.equal("centre depth, A", step.depth_A, depth, depth_range / depth.value,
               "the interpenetrating state has 56.45-56.48");
  const SmallerStress at = smaller_cauchy_force(problem, step);
  ledger.equal("upper end of the smaller stress, eV/A^3", at.largest / paper::thickness_A, stress,
               stress_range / stress.value, "thickness from plane stress, natural width where wrinkled");
  ledger.equal("least stress, eV/A^3", std::min(0.0, at.least) / paper::thickness_A, identity(0, "no compression"),
               1e-12);
  ledger.at_most("penetration of symmetry planes / side", step.penetration_A / paper::side_A,
                 identity(1e-6, "bound set for contact"));
}

}  // namespace

void verify_figure4(Ledger& ledger) {
  square(ledger, "quarter, 60 x 60 x 2 triangles", Extent::quarter, separate_code(56.31, "quarter with x, y >= 0 kept"),
         0.05, separate_code(0.0444, "range 0.0441-0.0447 by stress convention"), 0.0003);
  square(ledger, "full, 60 x 60 x 2 triangles", Extent::full, separate_code(56.34, "full plate"), 0.1,
         separate_code(0.04385, "range 0.0435-0.0442"), 0.00035);
}

}  // namespace validate::verify
