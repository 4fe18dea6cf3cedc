// A force–depth curve, or another quantity that grows with the depth, as a function of the depth.
#pragma once

#include <gsl/gsl_interp.h>

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "compare/results/result.hpp"

namespace validate {

/// Monotone interpolation (Steffen 1990) of ln F over ln depth: exact for power laws, which a straight chord
/// of F over depth overestimates by several per cent at the spacing of a run.
class Curve {
 public:
  /// Depths and values (forces in eV/Å, say), equally long, all positive, in any order. Throws
  /// std::invalid_argument for fewer than two different depths or values that are not positive and finite.
  Curve(std::span<const double> depth_A, std::span<const double> force_eV_per_A);

  /// The usable points of a run; throws as above.
  explicit Curve(const Run& run);

  double lowest_A() const;
  double highest_A() const;

  /// The value at a depth (Å); nothing outside the curve's own depths: never extrapolated.
  std::optional<double> at(double depth_A) const;

 private:
  struct FreeInterpolation {
    void operator()(gsl_interp* p) const { gsl_interp_free(p); }
  };
  std::vector<double> log_depth_, log_force_;
  std::unique_ptr<gsl_interp, FreeInterpolation> interpolation_;
};

}  // namespace validate
