// Symmetric matrices in which a node knows its two neighbours only, and their Cholesky factor: O(nodes).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "membrane/meridian/hermite.hpp"

namespace membrane::meridian {

using Block = Eigen::Matrix<double, dofs_per_node, dofs_per_node>;

struct BlockTridiagonal {
  std::vector<Block> diagonal;  ///< one per node
  std::vector<Block> below;     ///< below[i]: rows of node i + 1, columns of node i

  explicit BlockTridiagonal(int nodes)
      : diagonal(nodes, Block::Zero()), below(nodes > 0 ? nodes - 1 : 0, Block::Zero()) {}

  void set_zero();
  /// Makes row and column of a degree of freedom those of the unit matrix.
  void hold(int dof);
  Eigen::VectorXd operator*(const Eigen::VectorXd& x) const;
};

class BlockCholesky {
 public:
  /// L Lᵀ of K + share × its diagonal (of the size of it, and a little where it is zero). False, and no
  /// factor, if that is not positive definite or not finite.
  bool factorise(const BlockTridiagonal& K, double share = 0);

  Eigen::VectorXd solve(const Eigen::VectorXd& right_side) const;

 private:
  std::vector<Block> diagonal_;  ///< lower triangles
  std::vector<Block> below_;
};

}  // namespace membrane::meridian
