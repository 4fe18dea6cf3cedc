#include "atomistic/equilibrium/network_factor.hpp"

#include <algorithm>
#include <stdexcept>

namespace atomistic {

NetworkFactor::NetworkFactor(const Sheet& sheet, const SpringConstants& constants)
    : network_(sheet, constants, Blocks::lower) {
  lay_out();
  factor_.analyse(matrix_);
}

void NetworkFactor::lay_out() {
  const auto& start = network_.starts();
  const auto columns = static_cast<RoundedFactor::Index>(start.size()) - 1;
  matrix_.resize(3 * columns, 3 * columns);
  matrix_.resizeNonZeros(network_.numbers());
  RoundedFactor::Index* outer = matrix_.outerIndexPtr();
  RoundedFactor::Index* inner = matrix_.innerIndexPtr();
  for (RoundedFactor::Index j = 0; j < columns; ++j) {
    const long blocks = start[j + 1] - start[j];
    for (int c = 0; c < 3; ++c) {
      outer[3 * j + c] = 9 * start[j] + 3 * blocks * c;
      for (long b = start[j]; b < start[j + 1]; ++b)
        for (int r = 0; r < 3; ++r) *inner++ = 3 * network_.rows()[b] + r;
    }
  }
  outer[3 * columns] = network_.numbers();
  std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 1.0);
}

void NetworkFactor::set_up(const Eigen::VectorXd& positions, const std::vector<AtomStiffness>& load) {
  network_.assemble(positions, load, matrix_.valuePtr());
  if (!factor_.factorise(matrix_))
    throw std::runtime_error("the spring network's matrix could not be factorised: positions or constants are off");
}

Eigen::VectorXd NetworkFactor::solve(const Eigen::VectorXd& right_hand_side) const {
  return factor_.solve(right_hand_side);
}

}  // namespace atomistic
