// The preconditioner: stiffness of a spring network on the honeycomb's bonds at given positions.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "atomistic/equilibrium/rounded_factor.hpp"
#include "atomistic/lattice/sheet.hpp"
#include "atomistic/loads/load_term.hpp"
#include "atomistic/problem.hpp"

namespace atomistic {

/// Springs that reproduce a sheet's linear response; see spring_constants().
struct SpringConstants {
  double rest_length_A = 0;
  double stretch_eV_per_A2 = 0;       ///< k_r of an unstrained bond
  double softening = 0;               ///< s: a bond at strain ε has k_r (1 − s ε)
  double angle_eV = 0;                ///< k_θ, per angle and rad²
  double out_of_plane_eV_per_A2 = 0;  ///< k_o, per atom against the mean of its three neighbours
  double identity_eV_per_A2 = 1e-4;   ///< keeps the matrix definite
};

/// The constants whose network has the card's C11, C12 (inner displacement relaxed) and its fall under
/// strain:
///   k_r = √3 (C11 + C12),   1/(9 k_θ) = 1/D − 1/(3/2 k_r l²) with D = (C11 − C12) A_atom.
/// Out of plane one constant serves two ends: long waves ask for k_o = 16 κ A_atom / l⁴, the sublattices
/// against each other for a quarter of their stiffness. The two agree for Tersoff and differ by 3.6 for
/// AIREBO; their geometric mean leaves the same condition number on both sides.
SpringConstants spring_constants(const Card& card);

/// P(x), symmetric positive definite on the free atoms' 3·free_atoms degrees of freedom:
///   Σ bonds  k_r n nᵀ + max(T, 0)/l (I − n nᵀ),  T the tension of a bond that softens under strain
/// + Σ angles k_θ ∇θ ∇θᵀ + Σ atoms k_o g gᵀ,  g = ∇ m·(x_i − mean of its neighbours),  + identity,
/// and what a load adds to single atoms. An atom that slides in the plane has no z coupling.
/// The pattern is analysed once; factorise() refills and factorises, solve() serves any number of right-hand
/// sides.
class SpringNetwork {
 public:
  SpringNetwork(const Sheet& sheet, const SpringConstants& constants);

  /// Positions are those of all atoms, 3N. Throws std::runtime_error if the factorisation fails.
  void factorise(const Eigen::VectorXd& positions, const std::vector<AtomStiffness>& load = {});
  Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side) const;

  /// Lower triangle of P at the last factorised positions (diagonal blocks stored whole).
  const Eigen::SparseMatrix<double>& matrix() const { return matrix_; }

 private:
  struct Element;  ///< up to four atoms and one gradient of a scalar deformation

  void build_pattern();
  void assemble(const Eigen::VectorXd& positions, const std::vector<AtomStiffness>& load);
  void add_rank_one(double stiffness, const Element& element);
  void add_block(int i, int j, Eigen::Matrix3d block);
  bool slides(int atom) const { return !sheet_.slides.empty() && sheet_.slides[atom]; }
  void add_bonds(const Eigen::VectorXd& positions);
  void add_angles(const Eigen::VectorXd& positions);
  void add_out_of_plane(const Eigen::VectorXd& positions);

  const Sheet& sheet_;
  SpringConstants constants_;
  std::vector<int> rows_;    ///< block rows i >= j of each block column j, one after another
  std::vector<int> column_;  ///< where block column j starts in rows_
  Eigen::SparseMatrix<double> matrix_;
  RoundedFactor factor_;
};

}  // namespace atomistic
