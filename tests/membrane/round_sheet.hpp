// Problems of the round sheet, and its whole path, which must converge at every level.
#pragma once

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "membrane/problem.hpp"

namespace membrane::meridian::testing {

inline constexpr double a = 110;        // Å
inline constexpr double modulus = 8.0;  // E·h, eV/Å²

inline std::vector<Step> run(const Problem& problem, Report* report = nullptr) {
  std::vector<Step> steps;
  const Report end = solve(problem, [&](const Step& step) {
    steps.push_back(step);
    return true;
  });
  EXPECT_TRUE(end.converged) << end.reason;
  EXPECT_EQ(steps.size(), problem.levels.size());
  if (report) *report = end;
  return steps;
}

inline void refine(Problem& problem, double refinement) { problem.discretisation = Meridian{refinement}; }

inline Problem membrane_problem(double nu, Load load, std::vector<double> levels) {
  Problem problem;
  problem.sheet = DiscSheet{a};
  problem.discretisation = Meridian{};
  problem.law = StVenantKirchhoff{modulus, nu};
  problem.control = std::holds_alternative<PressureLoad>(load) ? Control::force : Control::conjugate_depth;
  problem.load = std::move(load);
  problem.levels = std::move(levels);
  return problem;
}

inline Problem plate_problem(Load load, std::vector<double> levels) {
  Problem problem = membrane_problem(0.3645, std::move(load), std::move(levels));
  problem.law = StVenantKirchhoff{17.33, 0.3645};
  problem.relaxed = false;
  problem.bending = clamped_all_round(0.966);
  return problem;
}

}  // namespace membrane::meridian::testing
