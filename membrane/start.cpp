#include "membrane/start.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace membrane {

Eigen::VectorXd start_shape(const Mesh& mesh, const Eigen::VectorXd& pattern_weights, double sheet_radius_A,
                            double load_radius_A, double conjugate_depth_A) {
  const double rim = std::hypot(sheet_radius_A, load_radius_A);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(mesh.dof_count());
  double depth = 0;
  for (int n = 0; n < mesh.node_count(); ++n) {
    if (mesh.held[n][2]) continue;
    const double w = 1 - std::pow(std::hypot(mesh.nodes[n].norm(), load_radius_A) / rim, 2.0 / 3);
    u[3 * n + 2] = -w;
    depth += pattern_weights[n] * w;
  }
  return u * (conjugate_depth_A / depth);
}

double start_depth(double force_eV_per_A, double sheet_modulus_eV_per_A2, double pretension_eV_per_A2,
                   double sheet_radius_A) {
  const double cubic = sheet_modulus_eV_per_A2 / (sheet_radius_A * sheet_radius_A);
  const double linear = std::numbers::pi * std::max(0.0, pretension_eV_per_A2);
  double depth = std::cbrt(force_eV_per_A / cubic);  // above the root of a convex cubic: Newton only descends
  for (int i = 0; i < 100; ++i) {
    const double excess = (linear + cubic * depth * depth) * depth - force_eV_per_A;
    const double change = excess / (linear + 3 * cubic * depth * depth);
    depth -= change;
    if (!(std::abs(change) > 1e-6 * depth)) break;
  }
  return depth;
}

}  // namespace membrane
