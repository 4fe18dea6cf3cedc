// The metric of the minimisation: the spring network with what the load adds to it and gives back.
#pragma once

#include <Eigen/Core>

#include "atomistic/equilibrium/network_solver.hpp"
#include "atomistic/loads/load_term.hpp"

namespace atomistic {

class Preconditioner {
 public:
  Preconditioner(Preconditioning kind, const Sheet& sheet, const SpringConstants& constants)
      : sheet_(sheet), network_(make_network_solver(kind, sheet, constants)) {}

  /// Of this rank's part of a sheet, with the solver of all ranks.
  Preconditioner(const Sheet& part, std::unique_ptr<NetworkSolver> solver, const Team& team)
      : sheet_(part), network_(std::move(solver)), team_(&team) {}

  /// At the positions of all atoms; the load is at its level, or absent.
  void factorise(const Eigen::VectorXd& positions, LoadTerm* load);

  /// (P − k kᵀ)⁻¹ r by Sherman and Morrison's formula; k is what the load gives back.
  Eigen::VectorXd solve(const Eigen::VectorXd& r) const;

  /// P⁻¹c, kept until the next factorisation: the load's c is the same on the whole path.
  const Eigen::VectorXd& constraint_response(const Eigen::VectorXd& c);

  /// With the network's matrix, so far.
  int solves() const { return solves_; }

  double factor_s() const { return factor_s_; }
  double solve_s() const { return solve_s_; }

 private:
  Eigen::VectorXd network_solve(const Eigen::VectorXd& r) const;

  const Sheet& sheet_;
  std::unique_ptr<NetworkSolver> network_;
  const Team* team_ = &alone;
  Eigen::VectorXd response_;  ///< P⁻¹k / √(1 − kᵀP⁻¹k); empty: no k
  Eigen::VectorXd constraint_response_;
  double factor_s_ = 0;
  mutable double solve_s_ = 0;
  mutable int solves_ = 0;
};

}  // namespace atomistic
