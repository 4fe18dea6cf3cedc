#include "membrane/bending/bending.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace membrane {
namespace {

Eigen::Vector3d in_space(const Eigen::Vector2d& point) { return {point[0], point[1], 0}; }

}  // namespace

Bending::Bending(const std::vector<Eigen::Vector2d>& nodes, const std::vector<std::array<int, 3>>& triangles,
                 BendingModuli moduli, const std::function<SlopeSupport(int, int)>& slope)
    : nodes_(nodes) {
  moduli.check();
  for (const auto& corners : triangles) triangles_.push_back({corners, {}, {}});
  find_edges(slope);
  for (Triangle& triangle : triangles_) set_stiffness(triangle, moduli);
}

void Bending::find_edges(const std::function<SlopeSupport(int, int)>& slope) {
  std::map<std::pair<int, int>, int> started;  // (start, end) as the first triangle runs round it -> edge
  for (Triangle& triangle : triangles_)
    for (int i = 0; i < 3; ++i) {
      const int start = triangle.nodes[(i + 1) % 3];
      const int end = triangle.nodes[(i + 2) % 3];
      const auto first = started.find({end, start});
      if (first == started.end()) {
        triangle.edges[i] = static_cast<int>(edges_.size());
        triangle.side[i] = 1;
        if (!started.emplace(std::pair{start, end}, triangle.edges[i]).second)
          throw std::invalid_argument("bending: two triangles run round an edge in the same sense");
        edges_.push_back({Kind::free, {start, end, triangle.nodes[i], -1}, Eigen::Vector3d::Zero()});
      } else {
        Edge& edge = edges_[first->second];
        if (edge.kind == Kind::inner) throw std::invalid_argument("bending: an edge has three triangles");
        edge.kind = Kind::inner;
        edge.nodes[3] = triangle.nodes[i];
        triangle.edges[i] = first->second;
        triangle.side[i] = -1;
      }
    }
  for (Edge& edge : edges_)
    if (edge.kind == Kind::free && slope(edge.nodes[0], edge.nodes[1]) == SlopeSupport::held) {
      const Eigen::Vector2d along = nodes_[edge.nodes[1]] - nodes_[edge.nodes[0]];
      edge.kind = Kind::held;
      edge.outward = Eigen::Vector3d(along[1], -along[0], 0).normalized();
    }
}

/// ½ A [κ (tr K)² + 2 κG det K] = ½ φ·Q φ, Q_ij = [(κ + κG) l_i l_j − κG l_i l_j (m_i·m_j)²]/A.
void Bending::set_stiffness(Triangle& triangle, BendingModuli moduli) const {
  std::array<Eigen::Vector2d, 3> e;
  for (int i = 0; i < 3; ++i) e[i] = nodes_[triangle.nodes[(i + 2) % 3]] - nodes_[triangle.nodes[(i + 1) % 3]];
  const double area = 0.5 * (e[0][0] * e[1][1] - e[0][1] * e[1][0]);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double lengths = e[i].norm() * e[j].norm();
      const double cosine = e[i].dot(e[j]) / lengths;
      triangle.stiffness(i, j) =
          lengths * (moduli.mean_eV + moduli.gaussian_eV - moduli.gaussian_eV * cosine * cosine) / area;
    }
}

HingeCorners Bending::corners(const Edge& edge, const Eigen::VectorXd& u) const {
  HingeCorners x;
  for (int c = 0; c < corner_count(edge.kind); ++c)
    x[c] = in_space(nodes_[edge.nodes[c]]) + u.segment<3>(3 * edge.nodes[c]);
  if (edge.kind == Kind::held) x[3] = x[0] + edge.outward;
  return x;
}

/// Held: the fourth corner goes with the first.
HingeSlope Bending::slope_of(const Edge& edge, const Eigen::VectorXd& u) const {
  if (edge.kind == Kind::free) return HingeSlope::Zero();
  HingeSlope slope = hinge_slope(corners(edge, u));
  if (edge.kind == Kind::held) slope.head<3>() += slope.tail<3>();
  return slope;
}

Hinge Bending::hinge_of(const Edge& edge, const Eigen::VectorXd& u) const {
  if (edge.kind == Kind::free) return {};
  Hinge at = hinge(corners(edge, u));
  if (edge.kind == Kind::held) {
    at.gradient.head<3>() += at.gradient.tail<3>();
    at.hessian.topRows<3>() += at.hessian.bottomRows<3>();
    at.hessian.leftCols<3>() += at.hessian.rightCols<3>();
  }
  return at;
}

std::vector<double> Bending::folds(const Eigen::VectorXd& u) const {
  std::vector<double> folds(edges_.size(), 0);
  for (std::size_t e = 0; e < edges_.size(); ++e)
    if (edges_[e].kind != Kind::free) folds[e] = hinge_angle(corners(edges_[e], u));
  return folds;
}

Eigen::Vector3d Bending::moments(const Triangle& triangle, const std::vector<double>& folds,
                                 const Eigen::VectorXd& rotations) const {
  Eigen::Vector3d phi;
  for (int i = 0; i < 3; ++i) {
    const int e = triangle.edges[i];
    const Kind kind = edges_[e].kind;
    phi[i] = fold_share(kind) * folds[e] + tilt_share(kind) * triangle.side[i] * rotations[e];
  }
  return triangle.stiffness * phi;
}

double Bending::add_gradient(const Eigen::VectorXd& u, const Eigen::VectorXd& rotations, Eigen::VectorXd& by_u,
                             Eigen::VectorXd& by_rotations) const {
  const std::vector<double> fold = folds(u);
  std::vector<double> on_fold(edges_.size(), 0);
  double energy = 0;
  for (const Triangle& triangle : triangles_) {
    const Eigen::Vector3d moment = moments(triangle, fold, rotations);
    for (int i = 0; i < 3; ++i) {
      const int e = triangle.edges[i];
      const double by_fold = fold_share(edges_[e].kind) * moment[i];
      const double by_tilt = tilt_share(edges_[e].kind) * triangle.side[i] * moment[i];
      on_fold[e] += by_fold;
      by_rotations[e] += by_tilt;
      energy += 0.5 * (by_fold * fold[e] + by_tilt * rotations[e]);
    }
  }
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const HingeSlope slope = slope_of(edges_[e], u);
    for (int c = 0; c < corner_count(edges_[e].kind); ++c)
      by_u.segment<3>(3 * edges_[e].nodes[c]) += on_fold[e] * slope.segment<3>(3 * c);
  }
  return energy;
}

double Bending::uncancelled(const Eigen::VectorXd& u) const {
  std::vector<double> stiffness(edges_.size(), 0);
  for (const Triangle& triangle : triangles_)
    for (int i = 0; i < 3; ++i)
      stiffness[triangle.edges[i]] +=
          std::pow(fold_share(edges_[triangle.edges[i]].kind), 2) * triangle.stiffness(i, i);
  double squares = 0;
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const HingeSlope slope = slope_of(edges_[e], u);
    double angle = 0;
    for (int c = 0; c < corner_count(edges_[e].kind); ++c)
      angle += slope.segment<3>(3 * c).norm() * u.segment<3>(3 * edges_[e].nodes[c]).norm();
    squares += std::pow(stiffness[e] * angle, 2) * slope.squaredNorm();
  }
  return std::sqrt(squares);
}

/// Gᵀ Q G, G = dφ/d(nodes, rotations).
Bending::Part Bending::triangle_part(const Triangle& triangle, const std::vector<Hinge>& hinges) const {
  Part part;
  const auto slot = [](std::vector<int>& list, int item) {
    const auto at = std::find(list.begin(), list.end(), item);
    if (at != list.end()) return static_cast<int>(at - list.begin());
    list.push_back(item);
    return static_cast<int>(list.size()) - 1;
  };
  Eigen::Matrix<double, 3, 18> by_nodes = Eigen::Matrix<double, 3, 18>::Zero();
  Eigen::Matrix3d by_rotations = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i) {
    const int e = triangle.edges[i];
    const Edge& edge = edges_[e];
    for (int c = 0; c < corner_count(edge.kind); ++c)
      by_nodes.block<1, 3>(i, 3 * slot(part.nodes, edge.nodes[c])) +=
          fold_share(edge.kind) * hinges[e].gradient.segment<3>(3 * c).transpose();
    if (edge.kind != Kind::held) by_rotations(i, slot(part.rotations, e)) = triangle.side[i];
  }
  const Eigen::Index n = 3 * static_cast<Eigen::Index>(part.nodes.size());
  const Eigen::Index r = static_cast<Eigen::Index>(part.rotations.size());
  Eigen::MatrixXd G(3, n + r);
  G << by_nodes.leftCols(n), by_rotations.leftCols(r);
  part.k = G.transpose() * triangle.stiffness * G;
  return part;
}

Bending::Part Bending::fold_part(const Edge& edge, const Hinge& hinge, double moment) const {
  const int corners = corner_count(edge.kind);
  return {{edge.nodes.begin(), edge.nodes.begin() + corners},
          {},
          moment * hinge.hessian.topLeftCorner(3 * corners, 3 * corners)};
}

void Bending::over_hessian(const Eigen::VectorXd& u, const Eigen::VectorXd& rotations, const Visit& of_triangle,
                           const Visit& of_fold) const {
  std::vector<Hinge> hinges;
  hinges.reserve(edges_.size());
  for (const Edge& edge : edges_) hinges.push_back(hinge_of(edge, u));
  const std::vector<double> fold = folds(u);
  std::vector<double> on_fold(edges_.size(), 0);
  for (const Triangle& triangle : triangles_) {
    const Eigen::Vector3d moment = moments(triangle, fold, rotations);
    for (int i = 0; i < 3; ++i) on_fold[triangle.edges[i]] += fold_share(edges_[triangle.edges[i]].kind) * moment[i];
    of_triangle(triangle_part(triangle, hinges));
  }
  for (std::size_t e = 0; e < edges_.size(); ++e)
    if (edges_[e].kind != Kind::free) of_fold(fold_part(edges_[e], hinges[e], on_fold[e]));
}

}  // namespace membrane
