// solve() of problem.hpp: a problem's way to its discretisation.
#include "membrane/meridian/path.hpp"
#include "membrane/path/load_path.hpp"
#include "membrane/problem.hpp"

namespace membrane {
namespace {

struct FollowOn {
  const Problem& problem;
  const OnStep& on_step;
  Report operator()(const Triangles&) const { return follow_on_triangles(problem, on_step); }
  Report operator()(const Meridian&) const { return meridian::follow(problem, on_step); }
};

}  // namespace

Report solve(const Problem& problem, const OnStep& on_step) {
  check(problem);
  return std::visit(FollowOn{problem, on_step}, problem.discretisation);
}

}  // namespace membrane
