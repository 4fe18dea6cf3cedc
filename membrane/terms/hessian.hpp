// The Hessian of the total energy: symmetric, 3×3 blocks, a pattern that never changes.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>
#include <utility>
#include <vector>

#include "membrane/sheets/mesh.hpp"

namespace membrane {

/// Pairs of nodes that some energy couples, in any order and with repetitions.
using NodePairs = std::vector<std::pair<int, int>>;

/// Lower half over 3 degrees of freedom a node (eV/Å²). A term finds the places of its blocks once and then adds to
/// them without searching. Rows and columns of held degrees of freedom are those of the unit matrix.
class Hessian {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  /// Where the block of a pair of nodes lies.
  struct Place {
    int offset = 0;           ///< of its first entry among the values
    int column_length = 0;    ///< entries of its first column
    bool transposed = false;  ///< the stored block is that of the reversed pair
  };

  Hessian(const Held& held, NodePairs pairs);

  /// Place of the block (row node, column node), which must be among the constructor's pairs.
  Place place(int row_node, int column_node) const;

  void set_zero();

  /// Adds a block off the diagonal; its entries at held degrees of freedom must be zero.
  void add(const Place& place, const Eigen::Matrix3d& block);
  /// Adds the lower half of a block on the diagonal.
  void add_diagonal(int node, const Eigen::Matrix3d& block);

  /// The matrix, held rows and columns included.
  const Matrix& matrix();

 private:
  const Held& held_;
  Matrix matrix_;
  std::vector<int> block_rows_;   ///< row nodes of each column node, one column after the other
  std::vector<int> block_start_;  ///< where a column node starts in block_rows_
};

/// Zeroes the rows and columns of held components in a block.
inline void release_held(const std::array<bool, 3>& row, const std::array<bool, 3>& column, Eigen::Matrix3d& block) {
  for (int c = 0; c < 3; ++c) {
    if (row[c]) block.row(c).setZero();
    if (column[c]) block.col(c).setZero();
  }
}

}  // namespace membrane
