// Follower pressure on one side of a sheet whose edges stay in the planes that close it.
#pragma once

#include <array>
#include <vector>

#include "membrane/sheets/mesh.hpp"
#include "membrane/terms/term.hpp"

namespace membrane {

/// Energy −p V with V the volume between the sheet and the plane z = 0, V = Σ x1·(x2×x3)/6 over the triangles. Exact
/// with respect to the follower load p n dA on the linear triangles as long as the boundary lies in z = 0 or in planes
/// through the origin (symmetry planes): the cone over the boundary then has no volume, and the Hessian is symmetric
/// (Bonet & Wood, Nonlinear Continuum Mechanics, 2nd ed. 2008, ch. 8.5). Positive p pushes a sheet of counter-clockwise
/// triangles towards +z.
class Pressure final : public EnergyTerm {
 public:
  explicit Pressure(const Mesh& mesh) : mesh_(mesh) {}

  void set(double pressure_eV_per_A3) { pressure_ = pressure_eV_per_A3; }
  double value() const { return pressure_; }

  /// Å³, of the meshed part.
  double volume(const Eigen::VectorXd& u) const;
  /// dV/du (Å²) where nodes may move; at supports what they bear of a unit of pressure.
  Eigen::VectorXd volume_gradient(const Eigen::VectorXd& u) const;

  void couple(NodePairs& pairs) const override;
  void locate(const Hessian& hessian) override;
  double add_gradient(const Eigen::VectorXd& u, Eigen::VectorXd& gradient) override;
  void add_hessian(const Eigen::VectorXd& u, double share, Hessian& hessian) override;

 private:
  const Mesh& mesh_;
  double pressure_ = 0;
  std::vector<std::array<Hessian::Place, 3>> places_;  ///< per triangle: node pairs (0, 1), (1, 2), (2, 0)
};

}  // namespace membrane
