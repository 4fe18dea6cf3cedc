// Dead forces that pull the edges of a sheet outwards in its plane.
#pragma once

#include "membrane/terms/term.hpp"

namespace membrane {

/// −T Σ l (n·u) over the boundary sides of the edges that slide: a force T per reference length (eV/Å²) along each
/// side's outward normal n in the flat sheet, half on either end. Of a polygon it is the traction of an even stress, so
/// that a flat sheet is stressed evenly; on a round rim it is radial. Linear: it has no Hessian.
class EdgeTension final : public EnergyTerm {
 public:
  EdgeTension(const Mesh& mesh, double tension_eV_per_A2);

  void couple(NodePairs&) const override {}
  void locate(const Hessian&) override {}
  double add_gradient(const Eigen::VectorXd& u, Eigen::VectorXd& gradient) override;
  void add_hessian(const Eigen::VectorXd&, double, Hessian&) override {}
  double part_norm() const override { return forces_.norm(); }

  /// On the nodes of the mesh, three components each, eV/Å; nothing where a component is held.
  const Eigen::VectorXd& forces() const { return forces_; }

 private:
  Eigen::VectorXd forces_;
};

}  // namespace membrane
