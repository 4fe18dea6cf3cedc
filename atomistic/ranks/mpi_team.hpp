// All ranks of the program as one team.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "atomistic/team.hpp"

namespace atomistic {

class MpiTeam : public Team {
 public:
  MpiTeam();
  double sum(double own) const override;
  double largest(double own) const override;

  int rank() const { return rank_; }
  int ranks() const { return ranks_; }

  /// Of every rank, from the numbers 0 … count − 1 that each claims: who has which. Throws std::runtime_error where one
  /// is nobody's.
  std::vector<int> owners(const std::vector<int>& claimed, int count) const;

  /// How many each rank before this one has, and so on to all: ranks() + 1 sums.
  std::vector<int> starts(int own) const;

  /// Threes of numbers, `own` those of the atoms `ids`: into their places in `whole` on rank 0.
  void gather(const Eigen::VectorXd& own, const std::vector<int>& ids, Eigen::VectorXd& whole) const;

 private:
  int rank_ = 0, ranks_ = 1;
};

}  // namespace atomistic
