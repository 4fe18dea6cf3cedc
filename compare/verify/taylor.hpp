// Derivatives judged by the order at which the Taylor remainder falls, not by one step.
#pragma once

#include <cmath>
#include <limits>

namespace validate::verify {

/// log2 of how much the remainder (the norm of f(x + t v) minus its Taylor polynomial) falls when t is
/// halved. Infinite where the remainder is no more than rounding: the polynomial is exact there.
template <class Remainder>
double observed_order(Remainder remainder, double step, double noise) {
  const double coarse = remainder(step);
  if (coarse <= noise) return std::numeric_limits<double>::infinity();
  return std::log2(coarse / remainder(step / 4)) / 2;
}

}  // namespace validate::verify
