#include "atomistic/equilibrium/rounded_factor.hpp"

#include <algorithm>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>

namespace atomistic {
namespace {

// The widest vectors that the processor has; other compilers take what they are given.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define WIDEST_VECTORS __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define WIDEST_VECTORS
#endif

/// w −= l f
WIDEST_VECTORS void subtract(const float* l, double f, double* w, long n) {
  for (long i = 0; i < n; ++i) w[i] -= static_cast<double>(l[i]) * f;
}

/// l·w, in sums that the compiler may run side by side.
WIDEST_VECTORS double dot(const float* l, const double* w, long n) {
  constexpr int lanes = 16;
  double sums[lanes] = {};
  long i = 0;
  for (; i + lanes <= n; i += lanes)
    for (int k = 0; k < lanes; ++k) sums[k] += static_cast<double>(l[i + k]) * w[i + k];
  double sum = 0;
  for (; i < n; ++i) sum += static_cast<double>(l[i]) * w[i];
  for (const double part : sums) sum += part;
  return sum;
}

/// One supernode: columns first … first + columns, and the rows that they reach, themselves first; column-major values.
struct Supernode {
  long first, columns, rows;
  const RoundedFactor::Index* row;
  long values;
};

Supernode supernode(const cholmod_factor& L, std::size_t k) {
  using Index = RoundedFactor::Index;
  const auto* super = static_cast<const Index*>(L.super);
  const auto* pi = static_cast<const Index*>(L.pi);
  const auto* px = static_cast<const Index*>(L.px);
  return {super[k], super[k + 1] - super[k], pi[k + 1] - pi[k], static_cast<const Index*>(L.s) + pi[k], px[k]};
}

/// Doubles become floats in the same memory, front to back, so that none is overwritten before it is read. CHOLMOD
/// fills the memory anew when it factorises again.
void round_in_place(void* numbers, std::size_t count) {
  auto* bytes = static_cast<unsigned char*>(numbers);
  for (std::size_t i = 0; i < count; ++i) {
    double exact;
    std::memcpy(&exact, bytes + i * sizeof(double), sizeof exact);
    const float rounded = static_cast<float>(exact);
    std::memcpy(bytes + i * sizeof(float), &rounded, sizeof rounded);
  }
}

}  // namespace

RoundedFactor::RoundedFactor() {
  cholmod().nmethods = 1;
  cholmod().method[0].ordering = CHOLMOD_METIS;
  cholmod().postorder = 1;
  cholmod().print = 0;  // what it says is in its status
}

/// Eigen tells a matrix that is not positive definite, which is an answer, from nothing else.
void RoundedFactor::require_success() {
  const int status = cholmod().status;
  if (status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
  if (status == CHOLMOD_TOO_LARGE) throw std::runtime_error("the matrix is too large for CHOLMOD");
  if (status < CHOLMOD_OK) throw std::runtime_error("CHOLMOD has failed with status " + std::to_string(status));
}

void RoundedFactor::analyse(const Matrix& lower) {
  analyzePattern(lower);
  require_success();
}

bool RoundedFactor::factorise(const Matrix& lower) {
  factorize(lower);
  require_success();
  if (info() != Eigen::Success) return false;
  const cholmod_factor& L = *m_cholmodFactor;
  round_in_place(L.x, L.xsize);
  inverse_diagonal_.resize(L.n);
  long widest = 0;
  for (std::size_t k = 0; k < L.nsuper; ++k) {
    const Supernode s = supernode(L, k);
    widest = std::max(widest, s.rows);
    for (long j = 0; j < s.columns; ++j)
      inverse_diagonal_[static_cast<std::size_t>(s.first + j)] =
          1 / static_cast<double>(values()[s.values + j * s.rows + j]);
  }
  work_.resize(static_cast<std::size_t>(widest));
  return true;
}

void RoundedFactor::forward(double* x) const {
  const cholmod_factor& L = *m_cholmodFactor;
  double* w = work_.data();
  for (std::size_t k = 0; k < L.nsuper; ++k) {
    const Supernode s = supernode(L, k);
    std::copy_n(x + s.first, s.columns, w);
    std::fill(w + s.columns, w + s.rows, 0.0);
    const float* column = values() + s.values;
    for (long j = 0; j < s.columns; ++j, column += s.rows) {
      w[j] *= inverse_diagonal_[static_cast<std::size_t>(s.first + j)];
      subtract(column + j + 1, w[j], w + j + 1, s.rows - j - 1);
    }
    std::copy_n(w, s.columns, x + s.first);
    for (long i = s.columns; i < s.rows; ++i) x[s.row[i]] += w[i];
  }
}

void RoundedFactor::backward(double* x) const {
  const cholmod_factor& L = *m_cholmodFactor;
  double* w = work_.data();
  for (std::size_t k = L.nsuper; k-- > 0;) {
    const Supernode s = supernode(L, k);
    for (long i = 0; i < s.rows; ++i) w[i] = x[s.row[i]];
    for (long j = s.columns; j-- > 0;) {
      const float* column = values() + s.values + j * s.rows;
      w[j] -= dot(column + j + 1, w + j + 1, s.rows - j - 1);
      w[j] *= inverse_diagonal_[static_cast<std::size_t>(s.first + j)];
    }
    std::copy_n(w, s.columns, x + s.first);
  }
}

Eigen::VectorXd RoundedFactor::solve(const Eigen::VectorXd& right_hand_side) const {
  const auto* order = static_cast<const Index*>(m_cholmodFactor->Perm);
  Eigen::VectorXd x(right_hand_side.size()), solution(right_hand_side.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = right_hand_side[order[i]];
  forward(x.data());
  backward(x.data());
  for (Eigen::Index i = 0; i < x.size(); ++i) solution[order[i]] = x[i];
  return solution;
}

}  // namespace atomistic
