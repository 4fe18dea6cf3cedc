#include "membrane/meridian/block_tridiagonal.hpp"

#include <Eigen/Cholesky>

namespace membrane::meridian {
namespace {

constexpr double slack_share = 1e-8;  // of the largest diagonal: nodes of a slack sheet have no stiffness at all

}  // namespace

void BlockTridiagonal::set_zero() {
  for (Block& block : diagonal) block.setZero();
  for (Block& block : below) block.setZero();
}

void BlockTridiagonal::hold(int dof) {
  const int node = dof / dofs_per_node;
  const int local = dof % dofs_per_node;
  diagonal[node].row(local).setZero();
  diagonal[node].col(local).setZero();
  diagonal[node](local, local) = 1;
  if (node > 0) below[node - 1].row(local).setZero();
  if (node < static_cast<int>(below.size())) below[node].col(local).setZero();
}

Eigen::VectorXd BlockTridiagonal::operator*(const Eigen::VectorXd& x) const {
  const auto part = [](auto& vector, std::size_t node) {
    return vector.template segment<dofs_per_node>(dofs_per_node * node);
  };
  Eigen::VectorXd y(x.size());
  for (std::size_t i = 0; i < diagonal.size(); ++i) part(y, i) = diagonal[i] * part(x, i);
  for (std::size_t i = 0; i < below.size(); ++i) {
    part(y, i + 1) += below[i] * part(x, i);
    part(y, i) += below[i].transpose() * part(x, i + 1);
  }
  return y;
}

bool BlockCholesky::factorise(const BlockTridiagonal& K, double share) {
  diagonal_ = K.diagonal;
  below_ = K.below;
  Eigen::Vector4d least = Eigen::Vector4d::Zero();
  for (const Block& block : K.diagonal) least = least.cwiseMax(slack_share * block.diagonal().cwiseAbs());
  for (std::size_t i = 0; i < diagonal_.size(); ++i) {
    if (share > 0) diagonal_[i].diagonal() += share * K.diagonal[i].diagonal().cwiseAbs().cwiseMax(least);
    if (i > 0) diagonal_[i] -= below_[i - 1] * below_[i - 1].transpose();
    if (!diagonal_[i].allFinite()) return false;
    const Eigen::LLT<Block> cholesky(diagonal_[i]);
    if (cholesky.info() != Eigen::Success) return false;
    diagonal_[i] = cholesky.matrixL();
    if (i < below_.size())  // below L⁻ᵀ
      below_[i] = diagonal_[i].triangularView<Eigen::Lower>().solve(below_[i].transpose()).transpose();
  }
  return true;
}

Eigen::VectorXd BlockCholesky::solve(const Eigen::VectorXd& right_side) const {
  Eigen::VectorXd x = right_side;
  const auto part = [&](std::size_t node) { return x.segment<dofs_per_node>(dofs_per_node * node); };
  const std::size_t nodes = diagonal_.size();
  for (std::size_t i = 0; i < nodes; ++i) {
    if (i > 0) part(i) -= below_[i - 1] * part(i - 1);
    diagonal_[i].triangularView<Eigen::Lower>().solveInPlace(part(i));
  }
  for (std::size_t i = nodes; i-- > 0;) {
    if (i + 1 < nodes) part(i) -= below_[i].transpose() * part(i + 1);
    diagonal_[i].transpose().triangularView<Eigen::Upper>().solveInPlace(part(i));
  }
  return x;
}

}  // namespace membrane::meridian
