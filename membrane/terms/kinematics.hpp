// Three-node membrane triangle in 3-D: constant strain, finite displacements. Holzapfel, Nonlinear Solid
// Mechanics (2000), ch. 6 and 8, for the total Lagrangian form.
#pragma once

#include <Eigen/Core>

#include "membrane/laws/response.hpp"
#include "membrane/sheets/mesh.hpp"

namespace membrane {

/// Displacements of a triangle's nodes, one column per node (3×3, Å).
using NodeVectors = Eigen::Matrix3d;
/// Stiffness of a triangle, nodes' components together: [x1 y1 z1 x2 … z3] (eV/Å²).
using TriangleStiffness = Eigen::Matrix<double, 9, 9>;

/// Gradient of the displacement and the two columns F = dx/dX of the deformation gradient.
struct Deformation {
  Eigen::Matrix<double, 3, 2> displacement_gradient;
  Eigen::Matrix<double, 3, 2> F;

  Deformation(const Triangle& triangle, const NodeVectors& displacements)
      : displacement_gradient(displacements * triangle.shape_gradients.transpose()),
        F(displacement_gradient + Eigen::Matrix<double, 3, 2>::Identity()) {}

  /// E = (FᵀF − I)/2, from the displacement gradient: no cancellation at small strain.
  Voigt green_lagrange() const {
    const auto& G = displacement_gradient;
    const double angle = G(0, 1) + G(1, 0) + G.col(0).dot(G.col(1));
    return {G(0, 0) + 0.5 * G.col(0).squaredNorm(), G(1, 1) + 0.5 * G.col(1).squaredNorm(), angle};
  }
};

/// Forces on the nodes, column a: A F S ∇N_a (eV/Å).
inline NodeVectors node_forces(const Triangle& triangle, const Deformation& deformation, const Voigt& S) {
  Eigen::Matrix2d force;
  force << S[0], S[2], S[2], S[1];
  return triangle.area_A2 * deformation.F * (force * triangle.shape_gradients);
}

/// Lower half (the rest is not set) of A (Bᵀ dS/dE B + (∇N_a · S ∇N_b) I), with B = dE/du. It is positive
/// semi-definite where dS/dE is and S is not compressive.
inline void stiffness(const Triangle& triangle, const Deformation& deformation, const Response& at,
                      TriangleStiffness& k) {
  const auto& F = deformation.F;
  const auto& N = triangle.shape_gradients;
  Eigen::Matrix<double, 3, 9> B;
  for (int a = 0; a < 3; ++a) {
    B.block<1, 3>(0, 3 * a) = N(0, a) * F.col(0).transpose();
    B.block<1, 3>(1, 3 * a) = N(1, a) * F.col(1).transpose();
    B.block<1, 3>(2, 3 * a) = (N(1, a) * F.col(0) + N(0, a) * F.col(1)).transpose();
  }
  const Eigen::Matrix<double, 3, 9> DB = triangle.area_A2 * at.tangent_eV_per_A2 * B;
  const Voigt& S = at.force_eV_per_A2;
  for (int b = 0; b < 3; ++b) {
    const Eigen::Vector2d SN(S[0] * N(0, b) + S[2] * N(1, b), S[2] * N(0, b) + S[1] * N(1, b));
    for (int a = b; a < 3; ++a) {
      auto block = k.block<3, 3>(3 * a, 3 * b);
      block.noalias() = B.middleCols<3>(3 * a).transpose() * DB.middleCols<3>(3 * b);
      block.diagonal().array() += triangle.area_A2 * N.col(a).dot(SN);
    }
  }
}

}  // namespace membrane
