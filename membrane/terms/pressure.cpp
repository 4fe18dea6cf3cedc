#include "membrane/terms/pressure.hpp"

#include <Eigen/Geometry>

namespace membrane {
namespace {

/// Present positions of a triangle's corners, one a column (Å).
Eigen::Matrix3d positions(const Mesh& mesh, const Triangle& triangle, const Eigen::VectorXd& u) {
  Eigen::Matrix3d x;
  for (int a = 0; a < 3; ++a) {
    const int node = triangle.nodes[a];
    x.col(a) = u.segment<3>(3 * node);
    x.col(a).head<2>() += mesh.nodes[node];
  }
  return x;
}

/// Matrix of the cross product: cross(a) b = a × b.
Eigen::Matrix3d cross(const Eigen::Vector3d& a) {
  Eigen::Matrix3d m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

}  // namespace

double Pressure::volume(const Eigen::VectorXd& u) const {
  double volume = 0;
  for (const Triangle& triangle : mesh_.triangles) volume += positions(mesh_, triangle, u).determinant() / 6;
  return volume;
}

void Pressure::couple(NodePairs& pairs) const {
  for (const Triangle& triangle : mesh_.triangles)
    for (int a = 0; a < 3; ++a) pairs.emplace_back(triangle.nodes[a], triangle.nodes[(a + 1) % 3]);
}

void Pressure::locate(const Hessian& hessian) {
  places_.resize(mesh_.triangles.size());
  for (std::size_t t = 0; t < places_.size(); ++t)
    for (int a = 0; a < 3; ++a)
      places_[t][a] = hessian.place(mesh_.triangles[t].nodes[a], mesh_.triangles[t].nodes[(a + 1) % 3]);
}

/// The follower load of a unit of pressure, n dA / 3 on each corner. On what may move it is the gradient of
/// V; on the supports it is what they bear, which the cone's gradient is not.
Eigen::VectorXd Pressure::volume_gradient(const Eigen::VectorXd& u) const {
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(u.size());
  for (const Triangle& triangle : mesh_.triangles) {
    const Eigen::Matrix3d x = positions(mesh_, triangle, u);
    const Eigen::Vector3d area = 0.5 * (x.col(1) - x.col(0)).cross(x.col(2) - x.col(0));
    for (int node : triangle.nodes) gradient.segment<3>(3 * node) += area / 3;
  }
  return gradient;
}

double Pressure::add_gradient(const Eigen::VectorXd& u, Eigen::VectorXd& gradient) {
  if (pressure_ == 0) return 0;
  gradient -= pressure_ * volume_gradient(u);
  return -pressure_ * volume(u);
}

/// The gradient of −p V by a corner is −p (x_b × x_c)/6, and d(x_b × x_c)/dx_b = −cross(x_c): the block of the corners
/// (a, b) is p cross(x_c)/6, with (a, b, c) in turn. Sums over the triangles about a free node are those of the
/// follower load.
void Pressure::add_hessian(const Eigen::VectorXd& u, double share, Hessian& hessian) {
  if (pressure_ == 0 || share == 1) return;
  for (std::size_t t = 0; t < places_.size(); ++t) {
    const Triangle& triangle = mesh_.triangles[t];
    const Eigen::Matrix3d x = positions(mesh_, triangle, u);
    for (int a = 0; a < 3; ++a) {
      Eigen::Matrix3d block = (1 - share) * pressure_ / 6 * cross(x.col((a + 2) % 3));
      release_held(mesh_.held[triangle.nodes[a]], mesh_.held[triangle.nodes[(a + 1) % 3]], block);
      hessian.add(places_[t][a], block);
    }
  }
}

}  // namespace membrane
