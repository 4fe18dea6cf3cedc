// One harmonic vibration: constants, frequency and free energy.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "atomistic/temperature.hpp"

namespace atomistic {

namespace constants {
inline constexpr double boltzmann_eV_per_K = 8.617333262e-5;         // CODATA 2018
inline constexpr double hbar_eV_s = 6.582119569e-16;                 // CODATA 2018
inline constexpr double atomic_mass_eV_s2_per_A2 = 1.036426966e-28;  // CODATA 2018
}  // namespace constants

/// √(λ/m), rad/s; λ a Hessian's eigenvalue. NaN for a negative one.
inline double angular_frequency(double eigenvalue_eV_per_A2, double mass_u) {
  return std::sqrt(eigenvalue_eV_per_A2 / (mass_u * constants::atomic_mass_eV_s2_per_A2));
}

/// The same in THz without the 2π, negative for a negative eigenvalue.
inline double frequency_THz(double eigenvalue_eV_per_A2, double mass_u) {
  constexpr double per_THz = 1e12;
  const double omega = angular_frequency(std::abs(eigenvalue_eV_per_A2), mass_u);
  return std::copysign(omega / (2 * std::numbers::pi * per_THz), eigenvalue_eV_per_A2);
}

/// kT ln(ħω/kT), or kT ln(2 sinh(ħω/2kT)), which is ½ ħω at T = 0. NaN for a negative eigenvalue.
inline double oscillator_free_energy_eV(double eigenvalue_eV_per_A2, double mass_u, const Heat& heat) {
  const double kT = constants::boltzmann_eV_per_K * heat.temperature_K;
  const double energy = constants::hbar_eV_s * angular_frequency(eigenvalue_eV_per_A2, mass_u);
  if (heat.statistics == Statistics::classical) return kT > 0 ? kT * std::log(energy / kT) : 0;
  return energy / 2 + (kT > 0 ? kT * std::log1p(-std::exp(-energy / kT)) : 0);
}

}  // namespace atomistic
