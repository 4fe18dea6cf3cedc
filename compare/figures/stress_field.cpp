#include "compare/figures/stress_field.hpp"

#include <cmath>

#include "membrane/triangles/fields.hpp"

namespace validate {

std::vector<TriangleStress> stress_field(const membrane::Problem& problem, const membrane::Mesh& mesh,
                                         double thickness_A, const Eigen::VectorXd& displacements_A) {
  const membrane::SheetFields fields = membrane::fields_of(problem, mesh, displacements_A);
  std::vector<TriangleStress> stresses(mesh.triangles.size());
  for (std::size_t t = 0; t < stresses.size(); ++t) {
    TriangleStress& at = stresses[t];
    for (int a = 0; a < 3; ++a) at.corners_A[a] = mesh.nodes[mesh.triangles[t].nodes[a]];
    at.larger_eV_per_A3 = fields.cauchy_1_eV_per_A2[t] / thickness_A;
    at.smaller_eV_per_A3 = fields.cauchy_2_eV_per_A2[t] / thickness_A;
    at.state = fields.state[t];
    at.direction = {std::cos(fields.direction_rad[t]), std::sin(fields.direction_rad[t])};
  }
  return stresses;
}

}  // namespace validate
