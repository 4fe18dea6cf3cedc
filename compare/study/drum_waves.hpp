// The long flexural waves of a clamped round sheet under load.
#pragma once

#include <vector>

#include "atomistic/temperature.hpp"
#include "membrane/laws/cauchy_born.hpp"
#include "membrane/problem.hpp"

namespace validate {

/// What the waves run in.
struct Drum {
  double a_A = 0;             ///< clamp radius
  double slope_margin_A = 0;  ///< the slope there is this length times the curvature
  double bending_modulus_eV = 0;
  const membrane::CauchyBorn* law = nullptr;
  double area_per_atom_A2 = 0, mass_u = 0;
  double shortest_wave_A = 0;  ///< waves count with the weight exp(−(k/k_c)⁸), k_c = 2π over it
};

/// Eigenvalues of the Hessian of a sheet that bends, per atom (eV/Å²): of one harmonic cos mφ the vibrations out of the
/// plane, those in it following at once. det H is that of the plane's part times that of these, so that nothing is
/// counted twice beside vibrations in the plane. Rising. `state`: along the meridian; empty: flat and without force.
std::vector<double> flexural_eigenvalues(const Drum& drum, const std::vector<membrane::MeridianPoint>& state, int m);

/// Wave numbers (1/Å) of the same vibrations of the flat sheet, by κ k⁴.
std::vector<double> flat_wave_numbers(const Drum& drum, int m);

/// Free energy (eV) of the waves, up to a constant. NaN where one that counts is unstable.
class DrumWaves {
 public:
  DrumWaves(const Drum& drum, const atomistic::Heat& heat);
  double operator()(const std::vector<membrane::MeridianPoint>& state) const;

 private:
  Drum drum_;
  atomistic::Heat heat_;
  std::vector<std::vector<double>> weights_;  ///< by harmonic, of those that have any
};

}  // namespace validate
