#include "compare/figures/stress_field.hpp"

#include <cmath>

#include "membrane/laws/cauchy.hpp"
#include "membrane/laws/prestress.hpp"

namespace compare {
namespace {

/// Principal values of a symmetric tensor [11, 22, 12] and the direction of the larger one.
void principal(const membrane::Voigt& force, double thickness, TriangleStress& into) {
  const double mean = (force[0] + force[1]) / 2, difference = (force[0] - force[1]) / 2;
  const double radius = std::hypot(difference, force[2]), angle = std::atan2(force[2], difference) / 2;
  into.larger_eV_per_A3 = (mean + radius) / thickness;
  into.smaller_eV_per_A3 = (mean - radius) / thickness;
  into.direction = {std::cos(angle), std::sin(angle)};
}

}  // namespace

std::vector<TriangleStress> stress_field(const membrane::Problem& problem, const membrane::Mesh& mesh,
                                         const membrane::StVenantKirchhoff& law, double thickness,
                                         const Eigen::VectorXd& displacements) {
  const Eigen::Matrix2d& p = problem.prestress_eV_per_A2;
  const membrane::Voigt offset = membrane::offset_strain(law, membrane::Voigt(p(0, 0), p(1, 1), p(0, 1)));
  std::vector<TriangleStress> field;
  for (const membrane::Triangle& triangle : mesh.triangles) {
    membrane::NodeVectors u;
    TriangleStress& stress = field.emplace_back();
    for (int a = 0; a < 3; ++a) {
      u.col(a) = displacements.segment<3>(3 * triangle.nodes[a]);
      stress.corners_A[a] = mesh.nodes[static_cast<std::size_t>(triangle.nodes[a])];
    }
    const membrane::Voigt strain = membrane::Deformation(triangle, u).green_lagrange();
    principal(membrane::cauchy_force(law, strain, offset, problem.relaxed), thickness, stress);
    stress.state = problem.relaxed ? membrane::sheet_state(law, membrane::principal_strains(strain + offset))
                                   : membrane::SheetState::taut;
  }
  return field;
}

}  // namespace compare
