// The first guess of a path: a flat sheet without pretension has no stiffness out of its plane.
#pragma once

#include <Eigen/Core>

#include "membrane/triangles/model.hpp"
#include "membrane/triangles/newton.hpp"

namespace membrane {

/// How the flat sheet answers a small load if an artificial pretension stiffens it: the direction of the first step.
/// The model is left as it was. Displacements over all degrees of freedom per unit of the load (a node's force
/// pattern), or per unit of a motion of held nodes; not finite where even the stiffened sheet has no answer.
class StiffenedSheet {
 public:
  StiffenedSheet(Model& model, Newton& newton) : model_(model), newton_(newton) {}

  /// Answer to forces on the nodes (eV/Å).
  Eigen::VectorXd under_forces(const Eigen::VectorXd& forces);

  /// Answer to small displacements of held nodes, these included.
  Eigen::VectorXd under_motion(const Eigen::VectorXd& held_displacements);

 private:
  template <class Call>
  Eigen::VectorXd while_stiffened(Call call);

  Model& model_;
  Newton& newton_;
};

/// The flat sheet stretched as Hooke's law says of an even tension: a start that is stiff out of its plane.
Eigen::VectorXd evenly_stretched(Model& model, double tension_eV_per_A2);

/// The multiple of a shape at which U(shape) − work of the forces on it is least: where the load has lifted a sheet
/// that stiffens as it stretches.
double balanced_amplitude(Model& model, const Eigen::VectorXd& shape, const Eigen::VectorXd& forces);

}  // namespace membrane
