// Bending (and stretching) over a mesh as one sparse system, for tests that need no load path.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>
#include <utility>
#include <vector>

#include "membrane/bending/bending.hpp"
#include "membrane/laws/st_venant_kirchhoff.hpp"
#include "membrane/sheets/mesh.hpp"
#include "membrane/terms/kinematics.hpp"
#include "plate_meshes.hpp"

namespace membrane::testing {

/// Displacements and rotations, one vector each.
struct Shape {
  Eigen::VectorXd u, rotations;

  Shape(Eigen::VectorXd displacements, Eigen::VectorXd tilts)
      : u(std::move(displacements)), rotations(std::move(tilts)) {}

  template <class Position>
  Shape(const PlateMesh& mesh, const Bending& bending, Position position)
      : u(3 * mesh.nodes.size()), rotations(Eigen::VectorXd::Zero(bending.rotation_count())) {
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
      u.segment<3>(3 * n) = position(mesh.nodes[n]) - Eigen::Vector3d(mesh.nodes[n][0], mesh.nodes[n][1], 0);
  }
};

inline double energy_of(const Bending& bending, const Shape& at) {
  Eigen::VectorXd g = Eigen::VectorXd::Zero(at.u.size());
  Eigen::VectorXd r = Eigen::VectorXd::Zero(at.rotations.size());
  return bending.add_gradient(at.u, at.rotations, g, r);
}

/// Hessian over displacements, then rotations; held rotations on a unit diagonal.
inline Eigen::SparseMatrix<double> hessian_of(const Bending& bending, const Shape& at) {
  const Eigen::Index n = at.u.size();
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](const Bending::Part& part) {
    const auto dof = [&](Eigen::Index i) {
      const Eigen::Index split = 3 * static_cast<Eigen::Index>(part.nodes.size());
      return i < split ? 3 * part.nodes[i / 3] + i % 3 : n + part.rotations[i - split];
    };
    for (Eigen::Index i = 0; i < part.k.rows(); ++i)
      for (Eigen::Index j = 0; j < part.k.cols(); ++j) entries.emplace_back(dof(i), dof(j), part.k(i, j));
  };
  bending.over_hessian(at.u, at.rotations, add, add);
  for (int r = 0; r < bending.rotation_count(); ++r)
    if (bending.rotation_is_held(r)) entries.emplace_back(n + r, n + r, 1);
  Eigen::SparseMatrix<double> K(n + bending.rotation_count(), n + bending.rotation_count());
  K.setFromTriplets(entries.begin(), entries.end());
  return K;
}

/// Solves the rows and columns that are not prescribed, the others being zero.
inline Eigen::VectorXd solve_free(const Eigen::SparseMatrix<double>& K, const Eigen::VectorXd& load,
                                  const std::vector<bool>& prescribed) {
  Eigen::SparseMatrix<double> reduced = K;
  reduced.prune([&](Eigen::Index i, Eigen::Index j, double) { return i == j || (!prescribed[i] && !prescribed[j]); });
  Eigen::VectorXd right = load;
  for (Eigen::Index i = 0; i < right.size(); ++i)
    if (prescribed[i]) {
      right[i] = 0;
      reduced.coeffRef(i, i) = 1;
    }
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(reduced);
  EXPECT_EQ(factor.info(), Eigen::Success);
  return factor.solve(right);
}

/// A sheet that stretches and bends under dead forces: Newton's method with whole steps.
class PlateSolver {
 public:
  PlateSolver(const PlateMesh& mesh, const Bending& bending, StVenantKirchhoff law, std::vector<bool> prescribed)
      : bending_(bending), law_(law), prescribed_(std::move(prescribed)), nodes_(mesh.nodes.size()) {
    for (const auto& t : mesh.triangles) triangles_.push_back(make_triangle(mesh.nodes, t));
  }

  /// From x, displacements and rotations in one vector, to equilibrium.
  Eigen::VectorXd solve(const Eigen::VectorXd& load, Eigen::VectorXd x) const {
    for (int i = 0; i < 60; ++i) {
      Eigen::VectorXd gradient = Eigen::VectorXd::Zero(x.size());
      const Eigen::SparseMatrix<double> K = tangent(x, gradient);
      const Eigen::VectorXd step = solve_free(K, load - gradient, prescribed_);
      x += step;
      if (step.norm() <= 1e-9 * x.norm()) return x;
    }
    ADD_FAILURE() << "no equilibrium";
    return x;
  }

 private:
  Eigen::SparseMatrix<double> tangent(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) const {
    const Eigen::Index n = 3 * nodes_;
    Shape at{x.head(n), x.tail(x.size() - n)};
    Eigen::VectorXd by_u = Eigen::VectorXd::Zero(n);
    Eigen::VectorXd by_rotations = Eigen::VectorXd::Zero(x.size() - n);
    bending_.add_gradient(at.u, at.rotations, by_u, by_rotations);
    std::vector<Eigen::Triplet<double>> entries;
    for (const Triangle& triangle : triangles_) {
      NodeVectors displacements;
      for (int c = 0; c < 3; ++c) displacements.col(c) = at.u.segment<3>(3 * triangle.nodes[c]);
      const Deformation deformation(triangle, displacements);
      const Response response = law_(deformation.green_lagrange());
      const NodeVectors forces = node_forces(triangle, deformation, response.force_eV_per_A2);
      TriangleStiffness k;
      stiffness(triangle, deformation, response, k);
      for (int i = 0; i < 9; ++i) {
        const int row = 3 * triangle.nodes[i / 3] + i % 3;
        by_u[row] += forces(i % 3, i / 3);
        for (int j = 0; j < 9; ++j)
          entries.emplace_back(row, 3 * triangle.nodes[j / 3] + j % 3, i >= j ? k(i, j) : k(j, i));
      }
    }
    gradient << by_u, by_rotations;
    Eigen::SparseMatrix<double> stretching(x.size(), x.size());
    stretching.setFromTriplets(entries.begin(), entries.end());
    return stretching + hessian_of(bending_, at);
  }

  const Bending& bending_;
  StVenantKirchhoff law_;
  std::vector<bool> prescribed_;
  Eigen::Index nodes_;
  std::vector<Triangle> triangles_;
};

}  // namespace membrane::testing
