#include "compare/fitting/cantilever.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace validate {
namespace {

constexpr double near_enough = 1e-4;  // of the depth: what is left is done by Taylor's series
constexpr int most_steps = 60;

class InSeries {
 public:
  InSeries(ForceCurve sheet, double compliance) : sheet_(std::move(sheet)), compliance_(compliance) {}

  ForceAlong operator()(double z) {
    double depth = guess(z);
    for (int step = 0; step < most_steps; ++step) {
      const ForceAlong s = sheet_(depth);
      const double give = 1 + compliance_ * s.first.force;
      if (!(give > 0)) break;
      const double change = (z - depth - compliance_ * s.value.force) / give;
      if (std::abs(change) < near_enough * depth) return found(z, depth + change, moved(s, change));
      depth = std::clamp(depth + change, depth / 8, 8 * depth);
    }
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    last_z_ = none;
    return {{none, none, none}, {none, none, none}, none};
  }

 private:
  /// From the place asked for last, to second order.
  double guess(double z) const {
    const double away = z - last_z_, depth = last_depth_ + (first_ + second_ * away / 2) * away;
    return depth > 0 && depth <= z ? depth : z;
  }

  static ForceAlong moved(ForceAlong s, double by) {
    s.value.force += (s.first.force + s.second * by / 2) * by;
    s.value.by_Eh += s.first.by_Eh * by;
    s.value.by_pretension += s.first.by_pretension * by;
    s.first.force += s.second * by;
    return s;
  }

  /// At the depth that belongs to z: d′ = 1/(1 + F′/k).
  ForceAlong found(double z, double depth, const ForceAlong& s) {
    const double c = compliance_, by_z = 1 / (1 + c * s.first.force), cube = by_z * by_z * by_z;
    last_z_ = z;
    last_depth_ = depth;
    first_ = by_z;
    second_ = -c * s.second * cube;
    const auto slope = [&](double at, double along) { return along * by_z * by_z - c * at * s.second * cube; };
    return {{s.value.force, s.value.by_Eh * by_z, s.value.by_pretension * by_z},
            {s.first.force * by_z, slope(s.value.by_Eh, s.first.by_Eh),
             slope(s.value.by_pretension, s.first.by_pretension)},
            s.second * cube};
  }

  ForceCurve sheet_;
  double compliance_;
  double last_z_ = std::numeric_limits<double>::quiet_NaN(), last_depth_ = 0, first_ = 0, second_ = 0;
};

}  // namespace

ForceCurve in_series(ForceCurve sheet, double compliance) { return InSeries(std::move(sheet), compliance); }

}  // namespace validate
