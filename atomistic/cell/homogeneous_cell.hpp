// Flat periodic graphene under homogeneous strain, its sublattices relaxed against each other.
#pragma once

#include <Eigen/Core>
#include <string>

#include "atomistic/lammps/lammps.hpp"
#include "atomistic/problem.hpp"

namespace atomistic {

/// Rectangular four-atom cell, zigzag along x: a × √3 a, repeated. Empty above and below.
struct Supercell {
  int along_x, along_y;
  double a;

  int atoms() const { return 4 * along_x * along_y; }
  static int sublattice(int atom) { return atom % 2; }
  double area() const;
  Eigen::VectorXd positions() const;
  /// The cell under an upper-triangular deformation gradient.
  Box box(const Eigen::Matrix2d& f = Eigen::Matrix2d::Identity()) const;
};

/// Cell under a homogeneous upper-triangular deformation gradient f; membrane forces are Cauchy's, eV/Å².
class HomogeneousCell {
 public:
  HomogeneousCell(const Potential& potential, const Supercell& cell, const std::string& log_file);

  /// Atoms placed affinely.
  Eigen::Matrix2d affine(const Eigen::Matrix2d& f);

  /// The inner displacement relaxed by Newton's method, from zero or from where the last call left it.
  Eigen::Matrix2d relaxed(const Eigen::Matrix2d& f, bool from_last = false);

  double energy_per_atom() const { return energy_ / cell_.atoms(); }  ///< of the last state
  const Eigen::Vector2d& shift() const { return shift_; }             ///< of sublattice 1 in the deformed cell, Å
  bool in_balance() const { return in_balance_; }                     ///< whether the last relaxation ended well
  double longest_bond(const Eigen::Matrix2d& f) const;                ///< of the last state
  /// Whether the last state is a minimum over the inner displacement: by symmetry a balance can be a saddle.
  bool stable(const Eigen::Matrix2d& f);
  long evaluations() const { return forces_.timing().calls; }

 private:
  Eigen::Vector2d evaluate(const Eigen::Matrix2d& f);
  Eigen::Matrix2d shift_stiffness(const Eigen::Matrix2d& f, const Eigen::Vector2d& at_rest);

  Supercell cell_;
  Eigen::VectorXd flat_, atom_forces_;
  ForceField forces_;
  Eigen::Vector2d shift_ = Eigen::Vector2d::Zero();
  double energy_ = 0;
  bool in_balance_ = true;
};

/// Upper-triangular F with FᵀF = 1 + 2E.
Eigen::Matrix2d gradient_of_strain(const Eigen::Matrix2d& strain);

/// Second Piola–Kirchhoff membrane force J F⁻¹ N F⁻ᵀ of Cauchy's N.
Eigen::Matrix2d pulled_back(const Eigen::Matrix2d& f, const Eigen::Matrix2d& cauchy);

}  // namespace atomistic
