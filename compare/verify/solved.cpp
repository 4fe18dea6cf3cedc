#include "compare/verify/solved.hpp"

#include <stdexcept>

namespace validate::verify {

using namespace membrane;

std::vector<Step> solved(const Problem& problem) {
  std::vector<Step> steps;
  const Report report = solve(problem, [&](const Step& step) {
    steps.push_back(step);
    return true;
  });
  if (!report.converged) throw std::runtime_error("not converged: " + report.reason);
  return steps;
}

Step solved_last(const Problem& problem) { return solved(problem).back(); }

Problem round_sheet(double radius_A, double modulus_eV_per_A2, double nu, int rings) {
  Problem problem;
  problem.sheet = DiscSheet{.radius_A = radius_A, .rings = rings};
  problem.law = StVenantKirchhoff{modulus_eV_per_A2, nu};
  return problem;
}

}  // namespace validate::verify
