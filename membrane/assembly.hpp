// The stretching energy of a sheet, its gradient and its Hessian, over all degrees of freedom of a mesh.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>
#include <vector>

#include "membrane/laws/list.hpp"
#include "membrane/mesh.hpp"

namespace membrane {

/// What the triangles are made of.
struct Material {
  Law law;
  Voigt offset_strain = Voigt::Zero();  ///< the prestress, see laws/prestress.hpp
  bool relaxed = true;                  ///< tension-field energy
};

/// Displacements u are vectors over all degrees of freedom (Å), zero where held. Energies and forces are
/// those of the meshed part, not of its copies. Keeps a reference to the mesh.
class Assembly {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  Assembly(const Mesh& mesh, Material material);

  /// Energy relative to the flat prestressed sheet (eV); gradient: dU/du (eV/Å), at held degrees of freedom
  /// the reaction. Resizes the gradient, allocates nothing once it fits.
  double energy(const Eigen::VectorXd& u, Eigen::VectorXd& gradient);

  /// Root of the sum of squares of the triangles' forces on their nodes at the last energy(), eV/Å: the scale
  /// of what cancels in the gradient, and so of its rounding.
  double part_norm() const { return part_norm_; }

  /// Lower half of the Hessian (eV/Å²) in a pattern that never changes; held rows and columns are those of
  /// the unit matrix. Valid until the next call.
  const Matrix& hessian(const Eigen::VectorXd& u);

  /// The Hessian with a share of what compressive membrane forces take from it (∇N_a · S ∇N_b with S < 0)
  /// left out. With share 1 it is positive semi-definite for any law that is convex in strain; the relaxed
  /// laws have no compressive forces and need none of this.
  const Matrix& convex_hessian(const Eigen::VectorXd& u, double share);

  /// Whether compressive membrane forces can occur at all.
  bool bears_compression() const { return !material_.relaxed; }

  /// Membrane force (second Piola–Kirchhoff × thickness, eV/Å²) of one triangle.
  Voigt membrane_force(const Eigen::VectorXd& u, int triangle) const;

  /// Passes over all triangles so far, for energies and Hessians alike.
  int passes() const { return passes_; }

 private:
  void build_pattern();
  template <class Edit>
  const Matrix& assemble(const Eigen::VectorXd& u, Edit edit);

  const Mesh& mesh_;
  Material material_;
  double flat_energy_density_ = 0;
  double part_norm_ = 0;
  Matrix hessian_;
  /// Per triangle, for the lower half of its stiffness column by column: place in hessian_'s values, −1:
  /// held.
  std::vector<std::array<int, 45>> places_;
  std::vector<int> held_diagonal_;  ///< places of the unit entries
  int passes_ = 0;
};

}  // namespace membrane
