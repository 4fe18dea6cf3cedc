#include "atomistic/equilibrium/network_solver.hpp"

#include "atomistic/equilibrium/network_factor.hpp"
#include "atomistic/multigrid/multigrid.hpp"

namespace atomistic {
namespace {

class NetworkCycle : public NetworkSolver {
 public:
  NetworkCycle(const Sheet& sheet, const SpringConstants& constants)
      : network_(sheet, constants, Blocks::all), multigrid_(Ranks::this_one) {}

  NetworkCycle(const SheetPart& part, const SpringConstants& constants, std::vector<int> number)
      : network_(part.sheet, constants, Blocks::all, part.ghosts), multigrid_(Ranks::all), number_(std::move(number)) {}

  /// hypre has a matrix of its own: the numbers are ours only until it does.
  void set_up(const Eigen::VectorXd& positions, const std::vector<AtomStiffness>& load) override {
    const auto values = std::make_unique_for_overwrite<double[]>(static_cast<std::size_t>(network_.numbers()));
    network_.assemble(positions, load, values.get());
    multigrid_.set_up({.start = network_.starts(),
                       .column = network_.rows(),
                       .values = {values.get(), static_cast<std::size_t>(network_.numbers())},
                       .number = number_});
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side) const override {
    return multigrid_.cycle(right_hand_side);
  }

 private:
  SpringNetwork network_;
  Multigrid multigrid_;
  std::vector<int> number_;
};

}  // namespace

std::unique_ptr<NetworkSolver> make_network_solver(Preconditioning kind, const Sheet& sheet,
                                                   const SpringConstants& constants) {
  if (kind == Preconditioning::multigrid) return std::make_unique<NetworkCycle>(sheet, constants);
  return std::make_unique<NetworkFactor>(sheet, constants);
}

std::unique_ptr<NetworkSolver> make_shared_solver(const SheetPart& part, const SpringConstants& constants,
                                                  std::vector<int> number) {
  return std::make_unique<NetworkCycle>(part, constants, std::move(number));
}

}  // namespace atomistic
