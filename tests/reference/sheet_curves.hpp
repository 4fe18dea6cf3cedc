// Curves of a graphene drum from the solvers of this folder, which `validate verify fit` makes its noisy curves of.
#pragma once

#include <string>
#include <vector>

namespace reference {

/// A clamped St Venant–Kirchhoff sheet under a tip; nm, N/m and nN.
struct SheetCurve {
  std::string tip;  ///< disc or sphere
  double tip_radius_nm, pretension_N_per_m;
  std::vector<double> depth_nm, force_nN;
};

inline constexpr double drum_Eh_N_per_m = 342, drum_nu = 0.165, drum_radius_nm = 500;

/// Three tips by three pretensions, 60 depths each from 0.05 to 110 nm in equal ratios: F/d is smooth over ln d, and
/// eight of its values around a depth give it to 1e-7 of itself.
std::vector<SheetCurve> sheet_curves(int every = 1);

}  // namespace reference
