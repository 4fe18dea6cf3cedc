// Curves without noise of a graphene drum whose constants are known, from solvers that share no code with the fit.
#pragma once

#include <string>
#include <vector>

#include "compare/fitting/sheet_physics.hpp"

namespace validate::verify {

/// F/d over ln d of one sheet.
class KnownCurve {
 public:
  KnownCurve(MembraneTip tip, double Eh_eV_per_A2, double pretension_eV_per_A2, const std::vector<double>& depth_A,
             const std::vector<double>& force_eV_per_A);

  const MembraneTip& tip() const { return tip_; }
  double Eh_eV_per_A2() const { return Eh_; }
  double pretension_eV_per_A2() const { return pretension_; }

  /// Force (eV/Å) at a depth (Å); 0 before the contact. Of eight solved depths around it: right to 1e-7.
  double force(double depth_A) const;

  std::string name() const;  ///< "disc of 16.5 nm, 0.34 N/m"

 private:
  MembraneTip tip_;
  double Eh_, pretension_;
  std::vector<double> log_depth_, ratio_;
};

/// Those of sheet_curves.json, which tests/reference computes anew on every test run: tip after tip, three pretensions
/// each.
std::vector<KnownCurve> known_curves();

}  // namespace validate::verify
