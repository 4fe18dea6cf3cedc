// A quantity that is known at some places, smoothly in between.
#pragma once

#include <gsl/gsl_spline.h>

#include <memory>
#include <vector>

namespace validate {

/// Natural cubic spline; x ascending, three points or more (throws std::invalid_argument otherwise). Beyond the ends
/// the value of the end.
class SmoothCurve {
 public:
  SmoothCurve(const std::vector<double>& x, const std::vector<double>& y);

  double at(double x) const;

 private:
  struct FreeSpline {
    void operator()(gsl_spline* s) const { gsl_spline_free(s); }
  };
  double first_, last_;
  std::unique_ptr<gsl_spline, FreeSpline> spline_;
};

}  // namespace validate
