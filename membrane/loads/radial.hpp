// Dead forces of any round distribution.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

#include "membrane/loads/setting.hpp"

namespace membrane {

/// Dead transverse force of any round distribution: relative density over the radius, linear between the given pairs,
/// zero outside the last. Only ratios count.
struct RadialLoad {
  std::vector<double> radius_A, density;

  void check(const LoadSetting& setting) const {
    setting.require_centre();
    if (radius_A.empty() || radius_A.size() != density.size())
      refuse("load.density", density.size(), "must have as many entries as load.radius_A, at least one");
    if (!(radius_A.front() >= 0) || !std::is_sorted(radius_A.begin(), radius_A.end(), std::less_equal<>{}))
      refuse("load.radius_A", radius_A.front(), "must rise from 0 or more");
    for (double value : density)
      if (!(value >= 0 && std::isfinite(value))) refuse("load.density", value, "must be finite and not negative");
    LoadSetting::require_radius(radius_A.back(), setting.widest_patch_A);
  }

  SpreadForce action() const {
    return {radius_A.back(), [load = *this](double r) { return load.at(r); }};
  }

  /// Density at r <= the last radius.
  double at(double r) const {
    const auto above = std::lower_bound(radius_A.begin(), radius_A.end(), r) - radius_A.begin();
    if (above == 0) return density.front();
    if (above == static_cast<std::ptrdiff_t>(radius_A.size())) return density.back();
    const double share = (r - radius_A[above - 1]) / (radius_A[above] - radius_A[above - 1]);
    return (1 - share) * density[above - 1] + share * density[above];
  }
};

}  // namespace membrane
