#include "compare/pairing/guides.hpp"

#include "compare/pairing/smooth_curve.hpp"

namespace validate {

std::vector<atomistic::Guide> guides_from(const membrane::Problem& problem) {
  constexpr double spacing_A = 0.5;  // a third of a bond
  std::vector<atomistic::Guide> guides;
  membrane::solve(problem, [&](const membrane::Step& step) {
    if (!step.converged) return false;
    std::vector<double> radius, outward, depth;
    for (const membrane::MeridianPoint& point : step.on_meridian()) {
      radius.push_back(point.radius_A);
      outward.push_back(point.displacement_A);
      depth.push_back(point.depth_A);
    }
    const SmoothCurve u(radius, outward), w(radius, depth);
    atomistic::Guide guide{.level = problem.levels[static_cast<std::size_t>(step.level)],
                           .spacing_A = spacing_A,
                           .outward_A = {},
                           .depth_A = {}};
    for (int i = 0; i * spacing_A < radius.back(); ++i) {
      guide.outward_A.push_back(u.at(i * spacing_A));
      guide.depth_A.push_back(w.at(i * spacing_A));
    }
    guides.push_back(std::move(guide));
    return true;
  });
  return guides;
}

}  // namespace validate
