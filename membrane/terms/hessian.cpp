#include "membrane/terms/hessian.hpp"

#include <algorithm>

namespace membrane {

Hessian::Hessian(const Held& held, NodePairs pairs) : held_(held) {
  const int nodes = static_cast<int>(held.size());
  for (auto& [row, column] : pairs)
    if (row < column) std::swap(row, column);
  for (int n = 0; n < nodes; ++n) pairs.emplace_back(n, n);
  std::sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) {
    return a.second != b.second ? a.second < b.second : a.first < b.first;
  });
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());

  block_start_.assign(nodes + 1, 0);
  for (const auto& [row, column] : pairs) ++block_start_[column + 1];
  for (int n = 0; n < nodes; ++n) block_start_[n + 1] += block_start_[n];
  block_rows_.reserve(pairs.size());
  for (const auto& [row, column] : pairs) block_rows_.push_back(row);

  matrix_.resize(3 * nodes, 3 * nodes);
  matrix_.resizeNonZeros(9 * static_cast<Eigen::Index>(pairs.size()) - 3 * nodes);
  int* const outer = matrix_.outerIndexPtr();
  int* inner = matrix_.innerIndexPtr();
  for (int n = 0; n < nodes; ++n)
    for (int c = 0; c < 3; ++c) {
      outer[3 * n + c] = static_cast<int>(inner - matrix_.innerIndexPtr());
      for (int k = block_start_[n]; k < block_start_[n + 1]; ++k)
        for (int r = k == block_start_[n] ? c : 0; r < 3; ++r) *inner++ = 3 * block_rows_[k] + r;
    }
  outer[3 * nodes] = static_cast<int>(inner - matrix_.innerIndexPtr());
  set_zero();
}

Hessian::Place Hessian::place(int row_node, int column_node) const {
  const bool transposed = row_node < column_node;
  if (transposed) std::swap(row_node, column_node);
  const auto begin = block_rows_.begin() + block_start_[column_node];
  const auto end = block_rows_.begin() + block_start_[column_node + 1];
  const int position = static_cast<int>(std::lower_bound(begin, end, row_node) - begin);
  const int* const outer = matrix_.outerIndexPtr() + 3 * column_node;
  return {outer[0] + 3 * position, outer[1] - outer[0], transposed};
}

void Hessian::set_zero() { std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0); }

void Hessian::add(const Place& place, const Eigen::Matrix3d& block) {
  // Column c lacks c entries of the block on the diagonal above: the first entries of the three columns follow each
  // other at column_length − 1 and column_length − 2.
  double* value = matrix_.valuePtr() + place.offset;
  for (int c = 0; c < 3; ++c) {
    Eigen::Map<Eigen::Vector3d> column(value);
    if (place.transposed)
      column += block.row(c).transpose();
    else
      column += block.col(c);
    value += place.column_length - 1 - c;
  }
}

void Hessian::add_diagonal(int node, const Eigen::Matrix3d& block) {
  for (int c = 0; c < 3; ++c) {
    double* value = matrix_.valuePtr() + matrix_.outerIndexPtr()[3 * node + c];
    for (int r = c; r < 3; ++r) *value++ += block(r, c);
  }
}

const Hessian::Matrix& Hessian::matrix() {
  for (std::size_t n = 0; n < held_.size(); ++n)
    for (int c = 0; c < 3; ++c)
      if (held_[n][c]) matrix_.valuePtr()[matrix_.outerIndexPtr()[3 * n + c]] = 1;
  return matrix_;
}

}  // namespace membrane
