#include "compare/fitting/measured_scan.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "compare/fitting/models/list.hpp"

namespace validate {

WindowScan scan_of(const CurvePoints& points, const MeasuredOptions& options) {
  constexpr std::size_t windows = 20;
  constexpr double negligible = 1e-6;
  std::vector<std::size_t> order(points.depth_A.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return points.depth_A[i]; });
  const ForceModel model = force_model(closed_form(options.model, "--model").make(options.geometry));
  Likelihood whole(points, model, options.free);
  LikelihoodMaximum found = most_likely(whole);
  WindowScan scan;
  const std::size_t every = std::max<std::size_t>(1, order.size() / windows);
  // From the deepest on, each from the last: the shallow ones alone hardly know their contact.
  while (found.converged && order.size() >= fewest_points_to_fit && points.depth_A[order.back()] > 0) {
    Likelihood likelihood(selected(points, order), model, options.free);
    if (order.size() <= static_cast<std::size_t>(likelihood.parameter_count())) break;
    likelihood.take_slopes(found.theta);
    found = maximise(likelihood, found.theta, {}, negligible);
    if (!found.converged) break;
    scan.depth_max_A.push_back(points.depth_A[order.back()]);
    scan.Eh_eV_per_A2.push_back(found.theta[0]);
    scan.pretension_eV_per_A2.push_back(found.theta[1]);
    order.resize(order.size() - std::min(every, order.size()));
  }
  for (auto* column : {&scan.depth_max_A, &scan.Eh_eV_per_A2, &scan.pretension_eV_per_A2})
    std::ranges::reverse(*column);
  return scan;
}

}  // namespace validate
