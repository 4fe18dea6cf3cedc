#include "membrane/triangles/factor.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <new>

#include "membrane/triangles/tuning.hpp"

namespace membrane {
namespace {

/// CHOLMOD 3 opens four OpenMP threads for every supernode, whatever OMP_NUM_THREADS says; for matrices of
/// this size they only wait for each other (twice the time), and other models want the cores. Without an
/// active level a parallel region has one thread.
class OneThread {
 public:
  OneThread() { omp_set_max_active_levels(0); }
  ~OneThread() { omp_set_max_active_levels(before_); }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  int before_ = omp_get_max_active_levels();
};

/// Eigen tells a matrix that is not positive definite, which is an answer, and one that found no room alike.
void require_memory(const cholmod_common& state) {
  if (state.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
}

double scale_of(const Factor::Matrix& lower) { return lower.diagonal().cwiseAbs().maxCoeff(); }

}  // namespace

Factor::Factor() {
  cholesky_.cholmod().print = 0;  // "not positive definite" is an answer here, not news for a terminal
}

/// From the counts of the symbolic analysis: a factorisation does its operations some twelve times faster than a
/// solution, which waits for memory, does its four per entry.
int Factor::steps_worth() const {
  const cholmod_common& counts = cholesky_.cholmod();
  if (!(counts.lnz > 0)) return FactorTuning::fewest_steps;
  return std::clamp(static_cast<int>(counts.fl / (FactorTuning::operations_per_entry * counts.lnz)),
                    FactorTuning::fewest_steps, FactorTuning::most_steps);
}

bool Factor::attempt(const Matrix& lower, double shift) {
  ready_ = false;
  if (!std::isfinite(shift) || !lower.coeffs().allFinite()) return false;
  const OneThread one_thread;
  ++count_;
  cholesky_.setShift(shift);
  cholesky_.factorize(lower);
  require_memory(cholesky_.cholmod());
  ready_ = cholesky_.info() == Eigen::Success;
  return ready_;
}

bool Factor::factorise(const Matrix& lower, double damping) {
  if (!analysed_) {
    cholesky_.analyzePattern(lower);
    require_memory(cholesky_.cholmod());
    analysed_ = true;
  }
  return attempt(lower, damping == 0 ? 0 : damping * scale_of(lower));
}

bool Factor::factorise_singular(const Matrix& lower) {
  return attempt(lower, FactorTuning::smallest_shift * scale_of(lower));
}

}  // namespace membrane
