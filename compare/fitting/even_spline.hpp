// A cubic spline through values at equal steps, as cheap to ask for as a polynomial.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace validate {

/// A place between two of the steps: shared by all splines over the same steps.
struct EvenPlace {
  std::size_t i = 0;
  double before = 1, after = 0;                      ///< shares of the values
  double before_curvature = 0, after_curvature = 0;  ///< of the second derivatives
  double step = 1;
};

/// A value with its first and second derivative.
struct SplineAlong {
  double value = 0, first = 0, second = 0;
};

struct EvenSteps {
  double first = 0, step = 1;
  std::size_t count = 2;

  /// Outside the steps: their end.
  EvenPlace place(double x) const {
    const double t = std::clamp((x - first) / step, 0.0, static_cast<double>(count - 1));
    const auto i = std::min(static_cast<std::size_t>(t), count - 2);
    const double b = t - static_cast<double>(i), a = 1 - b;
    return {i, a, b, (a * a * a - a) * step * step / 6, (b * b * b - b) * step * step / 6, step};
  }
};

/// No curvature at the ends.
class EvenSpline {
 public:
  EvenSpline() = default;
  EvenSpline(const EvenSteps& steps, std::vector<double> values)
      : value_(std::move(values)), curvature_(value_.size()) {
    const std::size_t n = value_.size();
    std::vector<double> above(n, 0);  // Thomas's algorithm
    for (std::size_t i = 1; i + 1 < n; ++i) {
      const double pivot = 4 - above[i - 1];
      above[i] = 1 / pivot;
      const double bend = 6 * (value_[i + 1] - 2 * value_[i] + value_[i - 1]) / (steps.step * steps.step);
      curvature_[i] = (bend - curvature_[i - 1]) / pivot;
    }
    for (std::size_t i = n - 1; i-- > 1;) curvature_[i] -= above[i] * curvature_[i + 1];
  }

  double at(const EvenPlace& p) const {
    return p.before * value_[p.i] + p.after * value_[p.i + 1] + p.before_curvature * curvature_[p.i] +
           p.after_curvature * curvature_[p.i + 1];
  }

  SplineAlong along(const EvenPlace& p) const {
    const double a = p.before, b = p.after, from = curvature_[p.i], to = curvature_[p.i + 1];
    return {at(p),
            (value_[p.i + 1] - value_[p.i]) / p.step + p.step / 6 * ((3 * b * b - 1) * to - (3 * a * a - 1) * from),
            a * from + b * to};
  }

  /// Over the same steps; a spline without values is 0 everywhere.
  void add(double share, const EvenSpline& other) {
    value_.resize(other.value_.size());
    curvature_.resize(other.value_.size());
    for (std::size_t i = 0; i < value_.size(); ++i) {
      value_[i] += share * other.value_[i];
      curvature_[i] += share * other.curvature_[i];
    }
  }

 private:
  std::vector<double> value_, curvature_;
};

}  // namespace validate
