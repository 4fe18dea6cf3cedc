// Cubic B-splines on a uniform grid, as coefficients.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace membrane {

/// A coordinate cut into equal cells. A spline on it has cells + 3 coefficients; in cell n those from n to n
/// + 3 count.
struct SplineAxis {
  double from = 0, to = 0;
  int cells = 0;

  int size() const { return cells + 3; }
  double width() const { return (to - from) / cells; }
};

/// Values of the four B-splines that are not zero at a place, and their first and second derivatives by the
/// coordinate.
struct SplineBasis {
  int first = 0;  ///< index of the first one's coefficient
  std::array<double, 4> value{}, slope{}, bend{};
};

/// Of a place on the axis, or beyond it: there the place itself runs into a limit half a cell outside,
/// x -> end + ½ cell tanh((x − end)/½ cell), which leaves the spline twice continuously differentiable and
/// makes it a constant far out, where nothing is known.
inline SplineBasis spline_basis(const SplineAxis& axis, double x) {
  const double width = axis.width();
  const double end = std::clamp(x, axis.from, axis.to);
  const double reach = 0.5 * width;
  const double bent = std::tanh((x - end) / reach);
  const double place = end + reach * bent;
  const double rate = 1 - bent * bent;             // d place / dx
  const double change = -2 * bent * rate / reach;  // d² place / dx²

  SplineBasis at;
  const double cell = (place - axis.from) / width;
  at.first = std::clamp(static_cast<int>(std::floor(cell)), 0, axis.cells - 1);
  const double t = cell - at.first, s = 1 - t;
  const std::array<double, 4> value{s * s * s / 6, (4 - 6 * t * t + 3 * t * t * t) / 6,
                                    (4 - 6 * s * s + 3 * s * s * s) / 6, t * t * t / 6};
  const std::array<double, 4> slope{-s * s / 2, (3 * t - 4) * t / 2, (4 - 3 * s) * s / 2, t * t / 2};
  const std::array<double, 4> bend{s, 3 * t - 2, 3 * s - 2, t};
  for (int k = 0; k < 4; ++k) {
    at.value[k] = value[k];
    at.slope[k] = slope[k] / width * rate;
    at.bend[k] = bend[k] / (width * width) * rate * rate + slope[k] / width * change;
  }
  return at;
}

}  // namespace membrane
