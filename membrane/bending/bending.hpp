// The bending energy of a sheet of flat triangles, by mid-edge normals: Morley's plate element at any
// rotation.
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

#include "membrane/bending/hinge.hpp"
#include "membrane/bending/moduli.hpp"

namespace membrane {

/// What a boundary edge does to the sheet's slope across it. held: the sheet leaves the edge as it did when
/// flat, as at a clamp, and at a symmetry plane, whose outward normal is the edge's. free: no moment across
/// it.
enum class SlopeSupport { held, free };

/// Every edge carries a mid-edge normal; its tilt α out of the middle between its two triangles is a degree
/// of freedom, the edge's rotation. A triangle's curvature is what Stokes' theorem makes of the angles φ_i
/// from its own normal to those of its edges (length l_i, outward conormal m_i, area A, all of the flat
/// reference):
///   K = 1/A Σ l_i φ_i m_i⊗m_i,   φ = ½ θ ± α, θ the fold at the edge.
/// Neighbours share the normal, so that constant curvature is exact on any mesh, as in the element of Morley
/// (Aeronaut. Q. 19 (1968) 149), to which this comes down at small slopes; folds alone depend on the mesh's
/// directions (Grinspun, Gingold, Reisman & Zorin, Comput. Graph. Forum 25 (2006) 547). Curvature is counted
/// per reference length, which differs from the deformed surface's by the stretch.
class Bending {
 public:
  /// slope(a, b): the support of a boundary edge between two nodes. Throws std::invalid_argument for moduli
  /// of a sheet that is not stable, and for triangles that are no surface.
  Bending(const std::vector<Eigen::Vector2d>& nodes, const std::vector<std::array<int, 3>>& triangles,
          BendingModuli moduli, const std::function<SlopeSupport(int, int)>& slope);

  /// One an edge; those of held edges have no effect.
  int rotation_count() const { return static_cast<int>(edges_.size()); }
  bool rotation_is_held(int rotation) const { return edges_[rotation].kind == Kind::held; }
  std::array<int, 2> ends(int rotation) const { return {edges_[rotation].nodes[0], edges_[rotation].nodes[1]}; }

  /// Energy (eV); adds its derivatives by displacements u (three a node, Å) and rotations (one an edge).
  double add_gradient(const Eigen::VectorXd& u, const Eigen::VectorXd& rotations, Eigen::VectorXd& by_u,
                      Eigen::VectorXd& by_rotations) const;

  /// Root of the sum of squares of the nodes' forces that each edge's fold would cause if the displacements
  /// in it did not cancel, eV/Å. Times 1e-16 it is the rounding of the gradient.
  double uncancelled(const Eigen::VectorXd& u) const;

  /// A part of the Hessian over a few nodes and rotations.
  struct Part {
    std::vector<int> nodes, rotations;
    Eigen::MatrixXd k;  ///< three components a node, then the rotations
  };
  /// Calls visit for the parts whose sum is the Hessian, always in the same order: one a triangle, positive
  /// semi-definite, and one a fold, for the change of its direction under the moments it bears, which is not.
  using Visit = std::function<void(const Part&)>;
  void over_hessian(const Eigen::VectorXd& u, const Eigen::VectorXd& rotations, const Visit& of_triangle,
                    const Visit& of_fold) const;

 private:
  enum class Kind { inner, held, free };
  struct Edge {
    Kind kind = Kind::free;
    std::array<int, 4> nodes{};                         ///< as HingeCorners; the fourth of inner edges only
    Eigen::Vector3d outward = Eigen::Vector3d::Zero();  ///< of a held edge: its conormal in the flat sheet
  };
  struct Triangle {
    std::array<int, 3> nodes{};
    std::array<int, 3> edges{};                           ///< opposite to each node
    std::array<double, 3> side{};                         ///< +1: the edge's first triangle, −1: its second
    Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();  ///< of the moments about its edges against φ, eV
  };

  void find_edges(const std::function<SlopeSupport(int, int)>& slope);
  void set_stiffness(Triangle& triangle, BendingModuli moduli) const;
  HingeCorners corners(const Edge& edge, const Eigen::VectorXd& u) const;
  HingeSlope slope_of(const Edge& edge, const Eigen::VectorXd& u) const;
  Hinge hinge_of(const Edge& edge, const Eigen::VectorXd& u) const;
  std::vector<double> folds(const Eigen::VectorXd& u) const;
  Eigen::Vector3d moments(const Triangle& triangle, const std::vector<double>& folds,
                          const Eigen::VectorXd& rotations) const;
  Part triangle_part(const Triangle& triangle, const std::vector<Hinge>& hinges) const;
  Part fold_part(const Edge& edge, const Hinge& hinge, double moment) const;

  /// φ = fold_share θ + tilt_share side α.
  static double fold_share(Kind kind) { return kind == Kind::inner ? 0.5 : kind == Kind::held ? 1 : 0; }
  static double tilt_share(Kind kind) { return kind == Kind::held ? 0 : 1; }
  static int corner_count(Kind kind) { return kind == Kind::inner ? 4 : kind == Kind::held ? 3 : 0; }

  std::vector<Eigen::Vector2d> nodes_;
  std::vector<Edge> edges_;
  std::vector<Triangle> triangles_;
};

}  // namespace membrane
