// One part of the total energy: value, gradient and Hessian over the displacements of all nodes.
#pragma once

#include <Eigen/Core>

#include "membrane/terms/hessian.hpp"

namespace membrane {

/// Displacements u hold three components a node (Å). The total energy is the sum of its terms; one consistency test
/// walks over all of them.
class EnergyTerm {
 public:
  virtual ~EnergyTerm() = default;

  /// The pairs of nodes that the Hessian couples, besides each node with itself. Every term names its own.
  virtual void couple(NodePairs& pairs) const = 0;
  /// Called once, when the Hessian's pattern is there: find the places of the blocks.
  virtual void locate(const Hessian& hessian) = 0;

  /// The energy (eV); adds dU/du to the gradient, also at held degrees of freedom (eV/Å).
  virtual double add_gradient(const Eigen::VectorXd& u, Eigen::VectorXd& gradient) = 0;

  /// Adds the Hessian with a share (0 … 1) of its known negative curvature left out. With share 1 the term is positive
  /// semi-definite wherever it can be.
  virtual void add_hessian(const Eigen::VectorXd& u, double share, Hessian& hessian) = 0;

  /// Root of the sum of squares of the parts that the last add_gradient() summed up, eV/Å: the scale of what cancels in
  /// the gradient, and so of its rounding.
  virtual double part_norm() const { return 0; }

  /// What the energy is counted from (eV, not negative): the rounding of a small energy is a share of that.
  virtual double counted_from() const { return 0; }
};

}  // namespace membrane
