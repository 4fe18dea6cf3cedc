// The spring network's matrix solved with by its factor.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "atomistic/equilibrium/network_solver.hpp"
#include "atomistic/equilibrium/rounded_factor.hpp"

namespace atomistic {

class NetworkFactor : public NetworkSolver {
 public:
  NetworkFactor(const Sheet& sheet, const SpringConstants& constants);

  void set_up(const Eigen::VectorXd& positions, const std::vector<AtomStiffness>& load = {}) override;
  Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side) const override;

  /// Lower triangle of P at the last positions (diagonal blocks stored whole).
  const RoundedFactor::Matrix& matrix() const { return matrix_; }

 private:
  void lay_out();

  SpringNetwork network_;
  RoundedFactor::Matrix matrix_;
  RoundedFactor factor_;
};

}  // namespace atomistic
