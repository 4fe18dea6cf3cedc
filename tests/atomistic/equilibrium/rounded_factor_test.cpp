#include "atomistic/equilibrium/rounded_factor.hpp"

#include <SuiteSparse_config.h>
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <new>

namespace {

using namespace atomistic;
using Matrix = RoundedFactor::Matrix;

/// A grid's Laplacian with random weights, three unknowns a node that are coupled, and a shift: lower triangle.
Matrix grid(int side, double shift, unsigned seed) {
  std::srand(seed);
  const int n = 3 * side * side;
  Eigen::MatrixXd full = shift * Eigen::MatrixXd::Identity(n, n);
  const auto spring = [&](int i, int j) {
    const Eigen::Vector3d d = Eigen::Vector3d::Random() + Eigen::Vector3d(1, 0, 0);
    const Eigen::Matrix3d k = d * d.transpose();
    full.block<3, 3>(3 * i, 3 * i) += k;
    full.block<3, 3>(3 * j, 3 * j) += k;
    full.block<3, 3>(3 * i, 3 * j) -= k;
    full.block<3, 3>(3 * j, 3 * i) -= k;
  };
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      if (x + 1 < side) spring(y * side + x, y * side + x + 1);
      if (y + 1 < side) spring(y * side + x, (y + 1) * side + x);
    }
  return full.triangularView<Eigen::Lower>().toDenseMatrix().sparseView();
}

Eigen::VectorXd solved_densely(const Matrix& lower, const Eigen::VectorXd& b) {
  const Eigen::MatrixXd full = Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
  return full.llt().solve(b);
}

TEST(RoundedFactor, SolvesToSinglePrecision) {
  const Matrix a = grid(12, 0.1, 1);
  RoundedFactor factor;
  factor.analyse(a);
  ASSERT_TRUE(factor.factorise(a));
  const Eigen::VectorXd b = Eigen::VectorXd::Random(a.rows()), exact = solved_densely(a, b);
  const double error = (factor.solve(b) - exact).norm() / exact.norm();
  EXPECT_LT(error, 1e-5);
  EXPECT_GT(error, 1e-12);  // it is rounded
}

/// As a preconditioner has to be: bᵀP⁻¹c = cᵀP⁻¹b to double precision, whatever the rounding of the factor.
TEST(RoundedFactor, IsSymmetric) {
  const Matrix a = grid(12, 1e-3, 2);
  RoundedFactor factor;
  factor.analyse(a);
  ASSERT_TRUE(factor.factorise(a));
  const Eigen::VectorXd b = Eigen::VectorXd::Random(a.rows()), c = Eigen::VectorXd::Random(a.rows());
  const double one = b.dot(factor.solve(c)), other = c.dot(factor.solve(b));
  EXPECT_NEAR(one, other, 1e-10 * std::abs(b.dot(factor.solve(b))));
  EXPECT_GT(b.dot(factor.solve(b)), 0);
}

TEST(RoundedFactor, CanBeMadeAnewInTheSamePattern) {
  const Matrix a = grid(10, 0.1, 3), other = grid(10, 0.2, 4);
  RoundedFactor factor;
  factor.analyse(a);
  ASSERT_TRUE(factor.factorise(a));
  ASSERT_TRUE(factor.factorise(other));
  const Eigen::VectorXd b = Eigen::VectorXd::Random(a.rows()), exact = solved_densely(other, b);
  EXPECT_LT((factor.solve(b) - exact).norm(), 1e-5 * exact.norm());
}

TEST(RoundedFactor, SaysWhenThereIsNone) {
  Matrix a = grid(6, 0.1, 5);
  RoundedFactor factor;
  factor.analyse(a);
  a.coeffRef(30, 30) = -1;
  testing::internal::CaptureStdout();
  EXPECT_FALSE(factor.factorise(a));
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "") << "nobody reads it there";
}

/// CHOLMOD's own memory, for as long as this lives.
class NoMemory {
 public:
  NoMemory() {
    SuiteSparse_config.malloc_func = [](std::size_t) -> void* { return nullptr; };
    SuiteSparse_config.calloc_func = [](std::size_t, std::size_t) -> void* { return nullptr; };
    SuiteSparse_config.realloc_func = [](void*, std::size_t) -> void* { return nullptr; };
  }
  ~NoMemory() {
    SuiteSparse_config.malloc_func = malloc_;
    SuiteSparse_config.calloc_func = calloc_;
    SuiteSparse_config.realloc_func = realloc_;
  }
  NoMemory(const NoMemory&) = delete;
  NoMemory& operator=(const NoMemory&) = delete;

 private:
  decltype(SuiteSparse_config.malloc_func) malloc_ = SuiteSparse_config.malloc_func;
  decltype(SuiteSparse_config.calloc_func) calloc_ = SuiteSparse_config.calloc_func;
  decltype(SuiteSparse_config.realloc_func) realloc_ = SuiteSparse_config.realloc_func;
};

TEST(RoundedFactor, WantOfMemoryIsNoAnswerAboutTheMatrix) {
  const Matrix a = grid(6, 0.1, 6);
  RoundedFactor factor, other;
  factor.analyse(a);
  {
    const NoMemory none;
    EXPECT_THROW(factor.factorise(a), std::bad_alloc);
    EXPECT_THROW(other.analyse(a), std::bad_alloc);
  }
  EXPECT_TRUE(factor.factorise(a));
}

}  // namespace
