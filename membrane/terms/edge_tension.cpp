#include "membrane/terms/edge_tension.hpp"

namespace membrane {
EdgeTension::EdgeTension(const Mesh& mesh, double tension_eV_per_A2)
    : forces_(Eigen::VectorXd::Zero(3 * mesh.node_count())) {
  for (const auto& [start, end] : sliding_sides(mesh)) {
    const Eigen::Vector2d along = mesh.nodes[end] - mesh.nodes[start];
    const Eigen::Vector2d half(0.5 * tension_eV_per_A2 * along.y(), -0.5 * tension_eV_per_A2 * along.x());
    for (int node : {start, end}) forces_.segment<2>(3 * node) += half;
  }
  for (int n = 0; n < mesh.node_count(); ++n)
    for (int c = 0; c < 3; ++c)
      if (mesh.held[n][c]) forces_[3 * n + c] = 0;
}

double EdgeTension::add_gradient(const Eigen::VectorXd& u, Eigen::VectorXd& gradient) {
  gradient.head(forces_.size()) -= forces_;
  return -forces_.dot(u.head(forces_.size()));
}

}  // namespace membrane
