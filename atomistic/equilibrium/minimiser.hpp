// Preconditioned L-BFGS on one linear constraint: min E(x) with c·x held where it starts.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "atomistic/team.hpp"

namespace atomistic {

/// One evaluation of the energy: value and gradient with respect to the free degrees of freedom.
struct Evaluation {
  double energy = 0;
  Eigen::VectorXd gradient;
};

/// What is minimised and how it is preconditioned. n = number of free degrees of freedom.
struct Minimisation {
  std::function<Evaluation(const Eigen::VectorXd&)> evaluate;
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> precondition;  ///< P⁻¹ r
  Eigen::VectorXd constraint;                                           ///< c; empty: none
  Eigen::VectorXd constraint_response;  ///< P⁻¹c where it is known; empty: to be solved
  const Team* team = &alone;            ///< that the vectors are spread over; each rank has its part of all of them

  double dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const { return team->sum(a.dot(b)); }
  double norm(const Eigen::VectorXd& a) const { return std::sqrt(team->sum(a.squaredNorm())); }
};

struct MinimiserOptions {
  double force_tolerance = 1e-5;  ///< on the largest norm of an atom's gradient, constraint removed
  int memory = 20;
  double longest_step = 0.3;  ///< of any atom, Å
  int max_evaluations = 600;
  double trust_radius = 0;  ///< of Newton's first step, √eV in the metric; 0: what the preconditioner would take
};

struct MinimiserReport {
  bool converged = false;
  std::string reason;
  int evaluations = 0;
  Evaluation last;        ///< at the point returned
  double multiplier = 0;  ///< λ with gradient ≈ λ c
  double max_force = 0;
  double energy_residual = 0;  ///< gᵀP⁻¹g of the projected gradient, eV
  double trust_radius = 0;     ///< that Newton's method ended with
};

/// Called once per iteration with the evaluations so far and the largest force; false gives up.
using OnIteration = std::function<bool(int, double)>;

/// Moves x to a minimum. Does not throw for want of convergence.
MinimiserReport minimise(const Minimisation& problem, const MinimiserOptions& options, Eigen::VectorXd& x,
                         const OnIteration& on_iteration = {});

}  // namespace atomistic
