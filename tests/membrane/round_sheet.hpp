// Problems of the round sheet, and its whole path, which must converge at every level.
#pragma once

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "membrane/meridian/sheet.hpp"

namespace membrane::axisymmetric::testing {

inline constexpr double a = 110;        // Å
inline constexpr double modulus = 8.0;  // E·h, eV/Å²

inline std::vector<SheetStep> run(const SheetProblem& problem, SheetReport* report = nullptr) {
  std::vector<SheetStep> steps;
  const SheetReport end = solve(problem, [&](const SheetStep& step) {
    steps.push_back(step);
    return true;
  });
  EXPECT_TRUE(end.converged) << end.reason;
  EXPECT_EQ(steps.size(), problem.levels.size());
  if (report) *report = end;
  return steps;
}

inline SheetProblem membrane_problem(double nu, Load load, std::vector<double> levels) {
  SheetProblem problem;
  problem.radius_A = a;
  problem.law = StVenantKirchhoff{modulus, nu};
  problem.load = std::move(load);
  problem.levels = std::move(levels);
  return problem;
}

inline SheetProblem plate_problem(Load load, std::vector<double> levels) {
  SheetProblem problem = membrane_problem(0.3645, std::move(load), std::move(levels));
  problem.law = StVenantKirchhoff{17.33, 0.3645};
  problem.relaxed = false;
  problem.bending_modulus_eV = 0.966;
  return problem;
}

}  // namespace membrane::axisymmetric::testing
