#include "compare/fitting/sheet_ratio.hpp"

#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace validate {
namespace {

RatioCurve ratio_at(const MembraneTip& tip, const ShallowSheet& shallow, double Eh, double pretension,
                    const std::vector<double>& levels) {
  membrane::Problem problem = problem_of(tip, law_of(tip, Eh), pretension, levels);
  // A quarter of the usual elements: the forces change by less than 2e-5, without bending by 1e-6.
  if (!problem.bending) problem.discretisation = membrane::Meridian{tip.is_sphere() ? 0.25 : 0.5};
  RatioCurve curve;
  const membrane::Report report = membrane::solve(problem, [&](const membrane::Step& step) {
    if (!step.converged) return false;
    curve.log_depth.push_back(std::log(step.depth_A));
    curve.ratio.push_back(step.force_eV_per_A / shallow.force(step.depth_A, Eh, pretension));
    curve.last_level = levels[static_cast<std::size_t>(step.level)];
    return true;
  });
  if (curve.ratio.size() < 6) throw std::runtime_error("the membrane did not converge: " + report.reason);
  return curve;
}

}  // namespace

RatioCurve solved_ratio(const MembraneTip& tip, const ShallowSheet& shallow, double Eh, double pretension,
                        const Levels& between, int depths, double offset) {
  constexpr int parts = 8;  // of the step that the law ends in
  const double low = between.low, high = between.high;
  std::vector<double> levels;
  for (int i = 0; i < depths; ++i) levels.push_back(low * std::pow(high / low, (i + offset) / (depths - 1.0)));
  if (between.law_ends) {  // as close together there as for the sheet that was followed to its end
    const double before = levels[levels.size() - 2], after = levels.back();
    levels.pop_back();
    for (int i = 1; i <= parts; ++i) levels.push_back(std::lerp(before, after, static_cast<double>(i) / parts));
  }
  RatioCurve curve = ratio_at(tip, shallow, Eh, pretension, levels);
  const std::size_t reached = curve.ratio.size();
  if (reached == levels.size()) return curve;
  const double before = levels[reached - 1], after = levels[reached];
  levels.resize(reached);
  for (int i = 1; i < parts; ++i) levels.push_back(std::lerp(before, after, static_cast<double>(i) / parts));
  return ratio_at(tip, shallow, Eh, pretension, levels);
}

}  // namespace validate
