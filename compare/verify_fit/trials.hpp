// A case fitted many times over, with other noise each time: how wrong it is, and how often its intervals hold the
// truth.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compare/fitting/inference.hpp"
#include "compare/verify/ledger.hpp"
#include "compare/verify_fit/sheet_curves.hpp"

namespace validate::verify {

/// What is measured and what is told to the fit.
struct Experiment {
  bool zeros_free = false;  ///< contact and force zero are not told
  bool noise_known = true;  ///< σ of force and depth are told
  double radius_error = 0;  ///< relative standard error of the radius that is told
  double force_error = 0;   ///< of the forces' scale
  int points = 230;
};

/// One parameter over all curves, in eV/Å².
struct Tally {
  int covered = 0, finite = 0;
  double error = 0, square = 0, stated = 0;  ///< sums; `stated`: half widths of the finite intervals over 1.96
};

struct Trials {
  int curves = 0, fitted = 0;
  Tally Eh, pretension;
};

/// Fits `curves` drawn ones with the membrane's table; the same seed draws the same.
Trials try_fits(const KnownCurve& truth, const ForceModel& table, const std::vector<UncertainInput>& inputs,
                const Experiment& experiment, int curves, std::uint32_t seed);

/// Rows: all are fitted; the bias is below 0.2 of the stated error + 0.1 % of the value; the intervals hold the truth
/// in 93 to 97 % of the curves and have two ends. Of fewer than a thousand curves what chance adds to that in 99.9 % is
/// allowed too.
void add_rows(Ledger& ledger, const KnownCurve& truth, const Trials& trials);

}  // namespace validate::verify
