// Solving with the spring network's matrix: a factor, or one multigrid cycle.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "atomistic/equilibrium/spring_network.hpp"
#include "atomistic/lattice/sheet_part.hpp"
#include "atomistic/loads/load_term.hpp"

namespace atomistic {

/// The pattern is that of the sheet; set_up() takes the numbers at some positions, solve() serves any number of
/// right-hand sides.
class NetworkSolver {
 public:
  virtual ~NetworkSolver() = default;

  /// Positions are those of all atoms, 3N. Throws std::runtime_error if it fails, std::bad_alloc for want of memory.
  virtual void set_up(const Eigen::VectorXd& positions, const std::vector<AtomStiffness>& load) = 0;

  /// P̃⁻¹r: symmetric, positive definite, the same until the next set-up.
  virtual Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side) const = 0;
};

/// `kind` is not automatic. The sheet must outlive it.
std::unique_ptr<NetworkSolver> make_network_solver(Preconditioning kind, const Sheet& sheet,
                                                   const SpringConstants& constants);

/// One cycle over all ranks, each of which has its part. `number`: of the part's free atoms, own ones and ghosts, in
/// the matrix of all. The part must outlive it.
std::unique_ptr<NetworkSolver> make_shared_solver(const SheetPart& part, const SpringConstants& constants,
                                                  std::vector<int> number);

}  // namespace atomistic
