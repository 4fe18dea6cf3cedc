// The stiffness of a spring network on the honeycomb's bonds at given positions: the matrix of the preconditioner.
#pragma once

#include <Eigen/Core>
#include <vector>

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

/// Which blocks of a symmetric matrix are stored.
enum class Blocks { lower, all };

/// P(x), symmetric positive definite on the free atoms' 3·free_atoms degrees of freedom:
///   Σ bonds  k_r n nᵀ + max(T, 0)/l (I − n nᵀ),  T the tension of a bond that softens under strain
/// + Σ angles k_θ ∇θ ∇θᵀ + Σ atoms k_o g gᵀ,  g = ∇ m·(x_i − mean of its neighbours),  + identity,
/// and what a load adds to single atoms. An atom that slides in the plane has no z coupling.
/// Its pattern of 3×3 blocks, one block column for each free atom, and the numbers in memory of the caller's: column by
/// column of scalars, three for each block. Where all blocks are stored that is row by row just as well.
class SpringNetwork {
 public:
  /// `ghosts`: free atoms after the sheet's own ones that have rows, but no columns here (see SheetPart).
  SpringNetwork(const Sheet& sheet, const SpringConstants& constants, Blocks blocks, int ghosts = 0);

  /// Block rows of each block column, one column after another, ascending; starts() has where they begin and the end.
  const std::vector<int>& rows() const { return rows_; }
  const std::vector<long>& starts() const { return start_; }
  long numbers() const { return 9 * start_.back(); }

  /// Positions are those of all atoms, 3N; `values` has room for all numbers(). Diagonal blocks are whole.
  void assemble(const Eigen::VectorXd& positions, const std::vector<AtomStiffness>& load, double* values) const;

 private:
  struct Element;  ///< up to four atoms and one gradient of a scalar deformation

  void build_pattern();
  void add_rank_one(double stiffness, const Element& element, double* values) const;
  void add_block(int i, int j, Eigen::Matrix3d block, double* values) const;
  bool slides(int atom) const { return !sheet_.slides.empty() && sheet_.slides[atom]; }
  void add_identity(double* values) const;
  void add_bonds(const Eigen::VectorXd& positions, double* values) const;
  void add_angles(const Eigen::VectorXd& positions, double* values) const;
  void add_out_of_plane(const Eigen::VectorXd& positions, double* values) const;

  const Sheet& sheet_;
  SpringConstants constants_;
  Blocks blocks_;
  int rows_end_;  ///< free atoms, ghosts included
  std::vector<int> rows_;
  std::vector<long> start_;
};

}  // namespace atomistic
