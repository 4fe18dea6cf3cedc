// The paper's Eq. 16, the closed form that measured and computed curves are fitted with.
#pragma once

#include <span>

namespace validate {

/// F = σ0h π δ + E h q³ δ³/a², q = 1/(1.05 − 0.15 ν − 0.16 ν²).
///
/// Gil, Adhikari, Scarpa, Bonet, J. Phys.: Condens. Matter 22 (2010) 145302, Eq. 16; the form is that of Lee
/// et al., Science 321 (2008) 385. Meant for a point load on a clamped circular membrane: q³ is within 1 % of
/// the exact Föppl–von Kármán coefficient for ν >= 0, while the pretension term holds for no point load
/// (exact: 0.67 to 0.69 of it) and a tip of finite size is stiffer.
struct Eq16 {
  static constexpr int parameter_count = 2;  ///< E·h, σ0·h, both eV/Å²

  double a_A = 0;  ///< clamp radius
  double nu = 0;   ///< Poisson's ratio

  double q() const;

  /// Force in eV/Å at a depth in Å; E·h and σ0·h in eV/Å².
  double force(double depth_A, double Eh, double pretension) const;

  // What a fit asks for: value and gradient over the parameters (E·h, σ0·h).
  double value(double depth_A, std::span<const double> parameters) const;
  void gradient(double depth_A, std::span<const double> parameters, std::span<double> gradient) const;
};

}  // namespace validate
