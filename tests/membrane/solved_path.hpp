// The whole path of a problem, which must converge at every level.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "membrane/problem.hpp"

namespace membrane::testing {

inline std::vector<Step> solved_path(const Problem& problem) {
  std::vector<Step> steps;
  const Report report = solve(problem, [&](const Step& step) {
    steps.push_back(step);
    return true;
  });
  EXPECT_TRUE(report.converged) << report.reason;
  EXPECT_EQ(steps.size(), problem.levels.size());
  for (const Step& step : steps) {
    EXPECT_TRUE(step.converged);
    EXPECT_LE(step.relative_residual, 1e-8);
  }
  return steps;
}

/// A disc of St Venant–Kirchhoff's material, default mesh.
inline Problem disc_problem(double modulus, double nu, Load load, std::vector<double> levels, double radius = 110) {
  Problem problem;
  problem.sheet = DiscSheet{.radius_A = radius};
  problem.law = StVenantKirchhoff{modulus, nu};
  problem.load = std::move(load);
  problem.levels = std::move(levels);
  return problem;
}

}  // namespace membrane::testing
