// Bending as one of the terms of a mesh's total energy.
#pragma once

#include <vector>

#include "membrane/bending/bending.hpp"
#include "membrane/sheets/mesh.hpp"
#include "membrane/terms/term.hpp"

namespace membrane {

/// The rotations are the displacements of additional nodes, three on each, numbered from first_node on; as
/// displacements they count times half their edge's length (Å). Edges whose two nodes are held altogether are
/// clamped, those on a symmetry plane are held by it, all other boundary edges are free. The negative
/// curvature it may leave out is that of the folds' directions.
class BendingTerm final : public EnergyTerm {
 public:
  BendingTerm(const Mesh& mesh, BendingModuli moduli, int first_node);

  /// Of the additional nodes, to be appended to the others'.
  Held held_rotations() const;

  void couple(NodePairs& pairs) const override;
  void locate(const Hessian& hessian) override;
  double add_gradient(const Eigen::VectorXd& u, Eigen::VectorXd& gradient) override;
  void add_hessian(const Eigen::VectorXd& u, double share, Hessian& hessian) override;
  double part_norm() const override { return part_norm_; }

 private:
  /// A part of the Hessian over whole nodes, blocks of held components zero.
  struct Blocks {
    std::vector<int> nodes;
    Eigen::MatrixXd k;
  };
  Blocks blocks(const Bending::Part& part) const;
  std::vector<std::vector<int>> coupled_nodes() const;
  int additional_nodes() const { return (bending_.rotation_count() + 2) / 3; }
  int dof(int rotation) const { return 3 * first_node_ + rotation; }
  Eigen::VectorXd rotations(const Eigen::VectorXd& u) const;

  Held held_;  ///< of the mesh's nodes
  Bending bending_;
  int first_node_;
  double part_norm_ = 0;
  Eigen::VectorXd lever_A_;             ///< half the length of each edge
  std::vector<Hessian::Place> places_;  ///< of the blocks below the diagonal, part by part
};

}  // namespace membrane
