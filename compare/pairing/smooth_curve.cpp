#include "compare/pairing/smooth_curve.hpp"

#include <algorithm>
#include <functional>
#include <stdexcept>

namespace validate {

SmoothCurve::SmoothCurve(const std::vector<double>& x, const std::vector<double>& y) {
  if (x.size() != y.size() || x.size() < 3 || std::ranges::adjacent_find(x, std::greater_equal<>()) != x.end())
    throw std::invalid_argument("a smooth curve needs three ascending places and as many values");
  first_ = x.front();
  last_ = x.back();
  spline_.reset(gsl_spline_alloc(gsl_interp_cspline, x.size()));
  gsl_spline_init(spline_.get(), x.data(), y.data(), x.size());
}

double SmoothCurve::at(double x) const { return gsl_spline_eval(spline_.get(), std::clamp(x, first_, last_), nullptr); }

}  // namespace validate
