// The line that an edge is: a stress and a stiffness along it, as the free edge of a lattice has.
#pragma once

#include <array>
#include <vector>

#include "membrane/sheets/edge_elasticity.hpp"
#include "membrane/terms/term.hpp"

namespace membrane {

/// Over the boundary sides of the edges that slide. The negative curvature it may leave out is that of a line under
/// compression, and all of a negative K.
class EdgeLine final : public EnergyTerm {
 public:
  EdgeLine(const Mesh& mesh, EdgeElasticity elasticity);

  void couple(NodePairs& pairs) const override;
  void locate(const Hessian& hessian) override;
  double add_gradient(const Eigen::VectorXd& u, Eigen::VectorXd& gradient) override;
  void add_hessian(const Eigen::VectorXd& u, double share, Hessian& hessian) override;

  /// eV, of the meshed part.
  double energy(const Eigen::VectorXd& u) const;

 private:
  Eigen::Vector3d side(const std::array<int, 2>& nodes, const Eigen::VectorXd& u) const;

  const Mesh& mesh_;
  EdgeElasticity elasticity_;
  std::vector<std::array<int, 2>> sides_;
  std::vector<double> lengths_A_;  ///< in the flat sheet
  std::vector<Hessian::Place> places_;
};

}  // namespace membrane
