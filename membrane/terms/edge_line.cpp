#include "membrane/terms/edge_line.hpp"

#include <algorithm>

namespace membrane {

EdgeLine::EdgeLine(const Mesh& mesh, EdgeElasticity elasticity) : mesh_(mesh), elasticity_(elasticity) {
  sides_ = sliding_sides(mesh);
  for (const auto& [a, b] : sides_) lengths_A_.push_back((mesh.nodes[b] - mesh.nodes[a]).norm());
}

void EdgeLine::couple(NodePairs& pairs) const {
  for (const auto& [a, b] : sides_) pairs.emplace_back(a, b);
}

void EdgeLine::locate(const Hessian& hessian) {
  places_.clear();
  for (const auto& [a, b] : sides_) places_.push_back(hessian.place(a, b));
}

Eigen::Vector3d EdgeLine::side(const std::array<int, 2>& nodes, const Eigen::VectorXd& u) const {
  const auto& [a, b] = nodes;
  Eigen::Vector3d along = u.segment<3>(3 * b) - u.segment<3>(3 * a);
  along.head<2>() += mesh_.nodes[b] - mesh_.nodes[a];
  return along;
}

double EdgeLine::energy(const Eigen::VectorXd& u) const {
  double sum = 0;
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    const double e = side(sides_[k], u).norm() / lengths_A_[k] - 1;
    sum += lengths_A_[k] * e * (elasticity_.stress_eV_per_A + elasticity_.stiffness_eV_per_A * e / 2);
  }
  return sum;
}

double EdgeLine::add_gradient(const Eigen::VectorXd& u, Eigen::VectorXd& gradient) {
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    const auto& [a, b] = sides_[k];
    const Eigen::Vector3d along = side(sides_[k], u);
    const double e = along.norm() / lengths_A_[k] - 1;
    const Eigen::Vector3d force =
        (elasticity_.stress_eV_per_A + elasticity_.stiffness_eV_per_A * e) * along.normalized();
    gradient.segment<3>(3 * a) -= force;
    gradient.segment<3>(3 * b) += force;
  }
  return energy(u);
}

/// Per side: K/L d dᵀ + S/l (I − d dᵀ), d its direction, S the line's force.
void EdgeLine::add_hessian(const Eigen::VectorXd& u, double share, Hessian& hessian) {
  const auto kept = [&](double stiffness) { return stiffness < 0 ? (1 - share) * stiffness : stiffness; };
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    const auto& [a, b] = sides_[k];
    const Eigen::Vector3d along = side(sides_[k], u);
    const double length = along.norm(), e = length / lengths_A_[k] - 1;
    const double force = elasticity_.stress_eV_per_A + elasticity_.stiffness_eV_per_A * e;
    const Eigen::Matrix3d axial = along * along.transpose() / (length * length);
    const Eigen::Matrix3d block = kept(elasticity_.stiffness_eV_per_A / lengths_A_[k]) * axial +
                                  kept(force / length) * (Eigen::Matrix3d::Identity() - axial);
    for (const auto& [row, column, sign] : {std::array{a, a, 1}, std::array{b, b, 1}, std::array{a, b, -1}}) {
      Eigen::Matrix3d part = sign * block;
      release_held(mesh_.held[row], mesh_.held[column], part);
      if (row == column)
        hessian.add_diagonal(row, part);
      else
        hessian.add(places_[k], part);
    }
  }
}

}  // namespace membrane
