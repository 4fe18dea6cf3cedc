// Algebraic multigrid of a symmetric matrix of 3×3 blocks, its rows on one rank or on all: one cycle is one solve.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>

namespace atomistic {

/// The rows of this rank, whole (both triangles). Block row i has the blocks start[i] … start[i + 1] − 1, in the block
/// columns `column`: the first rows() of them are this rank's own, the others what it knows of others. Scalars lie row
/// by row: of row 3i + r, three for each block, from 9 start[i] + 3 r (start[i + 1] − start[i]) on.
struct BlockRows {
  std::span<const long> start;
  std::span<const int> column;
  std::span<const double> values;
  std::span<const int> number;  ///< of each block column, counted over all ranks, rank by rank; empty: its own

  int rows() const { return static_cast<int>(start.size()) - 1; }
  int number_of(int block_column) const { return number.empty() ? block_column : number[block_column]; }
};

enum class Ranks { this_one, all };

/// One W-cycle of hypre's BoomerAMG, from zero: symmetric and positive definite as the smoother is, and the same
/// function of its right-hand side until the next set-up, so that it can be the metric of a minimiser.
/// Block by unknown (displacements along x, y and z apart), no knowledge of the matrix's soft directions.
/// A V-cycle costs half of a W-cycle and leaves so much of the soft modes that a minimiser needs up to half as many
/// evaluations again: 13 instead of 9 at 600 Å (Tersoff, one depth from the continuum's shape).
class Multigrid {
 public:
  /// On all ranks, every rank constructs, sets up and solves. Throws std::runtime_error where the program was built
  /// without hypre.
  explicit Multigrid(Ranks ranks);
  ~Multigrid();
  Multigrid(const Multigrid&) = delete;
  Multigrid& operator=(const Multigrid&) = delete;

  /// Makes the hierarchy. Throws std::runtime_error with hypre's own words.
  void set_up(const BlockRows& rows);

  /// One cycle. This rank's part of the right-hand side and of the answer.
  Eigen::VectorXd cycle(const Eigen::VectorXd& right_hand_side) const;

 private:
  struct Hierarchy;
  std::unique_ptr<Hierarchy> hierarchy_;
};

}  // namespace atomistic
