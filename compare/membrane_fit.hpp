// The membrane model itself as the curve that is fitted: E·h and pretension free, the real tip.
#pragma once

#include <string>
#include <vector>

#include "compare/result.hpp"

namespace compare {

/// A clamped sheet and its tip, without E·h and pretension.
struct MembraneTip {
  double a_A = 0, nu = 0;
  double tip_A = 0;            ///< radius of the loaded disc; 0: a point
  double record_radius_A = 0;  ///< where the depth is taken; 0: the centre
};

struct MembraneFitReport {
  bool converged = false;
  std::string reason;  ///< why not
  int iterations = 0;  ///< curves of the membrane that were solved
  DirectFit fit;
  std::vector<double> residual_eV_per_A;
};

/// Forces (eV/Å) of a membrane at depths of record (Å).
std::vector<double> membrane_forces(const MembraneTip& tip, double Eh_eV_per_A2, double pretension_eV_per_A2,
                                    const std::vector<double>& depth_A);

/// Least squares with the finite-strain membrane. The shallow membrane's closed form gives the derivatives:
/// its curve, times the ratio of the two models at the last E·h and pretension, is fitted until neither
/// changes by more than 1e-6. The ratio hardly depends on them, so two to four curves are enough. `sigma`
/// (eV/Å) weights the points; empty: all alike. Not converging is reported, not thrown.
MembraneFitReport fit_membrane(const MembraneTip& tip, const std::vector<double>& depth_A,
                               const std::vector<double>& force_eV_per_A,
                               const std::vector<double>& sigma_eV_per_A);

}  // namespace compare
