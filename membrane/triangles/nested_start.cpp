#include "membrane/triangles/nested_start.hpp"

#include "membrane/sheets/rectangle.hpp"

namespace membrane {

std::optional<Eigen::VectorXd> guess_from_coarser(const Problem& problem, double value, int coarsest) {
  const auto* fine = std::get_if<RectangleSheet>(&problem.sheet);
  if (!fine || std::min(fine->cells_x, fine->cells_y) <= coarsest || fine->cells_x % 2 || fine->cells_y % 2)
    return std::nullopt;
  RectangleSheet coarse = *fine;
  coarse.cells_x /= 2;
  coarse.cells_y /= 2;
  Problem coarse_problem = problem;
  coarse_problem.sheet = coarse;
  coarse_problem.levels = {value};
  std::optional<Eigen::VectorXd> guess;
  solve(coarse_problem, [&](const Step& step) {
    if (step.converged) guess = interpolate(coarse, step.on_triangles().displacements, *fine);
    return true;
  });
  return guess;
}

}  // namespace membrane
