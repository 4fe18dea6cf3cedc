// What is asked of a sheet at a temperature and what comes back: plain data, Å, eV and K.
#pragma once

#include <string>
#include <vector>

namespace atomistic {

/// Of the vibrations. Classical: every mode has k_B T; quantum: zero-point motion and frozen modes.
enum class Statistics { classical, quantum };

struct Heat {
  double temperature_K = 0;
  Statistics statistics = Statistics::classical;
  int modes = 0;  ///< softest modes to hand out at each level
};

/// A vibration of the free atoms about an equilibrium.
struct Mode {
  double eigenvalue_eV_per_A2 = 0;  ///< of the Hessian; negative: the equilibrium is none
  double frequency_THz = 0;         ///< √(eigenvalue/mass)/2π; that of a negative eigenvalue counts as negative
  double out_of_plane = 0;          ///< share of z in the squared shape
  double radius_A = 0;              ///< mean distance from the axis, weighted by the squared shape
  std::vector<double> shape;        ///< 3·free atoms, of length 1
};

/// What a temperature does to one level of a path, in first order of the vibrations' free energy.
struct HeatedLevel {
  int level = 0;
  double force_eV_per_A = 0, conjugate_depth_A = 0;  ///< at T = 0
  bool stable = false;  ///< every vibration has a positive eigenvalue; nothing below is known otherwise but the modes
  double depth_shift_A = 0;                ///< of the conjugate depth's mean at that force, held
  double force_shift_eV_per_A = 0;         ///< of the mean force at that conjugate depth, held
  double compliance_A2_per_eV = 0;         ///< depth by force, T = 0
  double lowest_eigenvalue_eV_per_A2 = 0;  ///< of the Hessian
  double hessian_error_relative = 0;       ///< ‖H v − Δg‖/‖H v‖ along a random v
  int reach_bonds = 0, colours = 0;
  long force_calls = 0;
  double seconds = 0;
  std::vector<Mode> modes;
};

/// How long a level is sampled by dynamics.
struct Sampling {
  double temperature_K = 0;
  double length_ps = 0;
  double relative_error = 0;  ///< of the depth, at which it ends earlier; 0: it does not
  unsigned seed = 1;
};

/// What dynamics says of a level: the classical mean of the conjugate depth at its force, and all that is needed to go
/// on.
struct Sampled {
  int level = 0, stretches = 0;
  double mean_depth_A = 0, error_A = 0;  ///< standard error
  double samples = 0;                    ///< independent ones that the series is worth
  double warm_up_ps = 0, correlation_ps = 0, length_ps = 0;
  std::vector<double> depths_A;
  std::vector<double> positions_A, velocities_A_per_ps;
};

/// The flat sheet at a temperature, by the phonons of its cell. Moduli per area at its own lattice constant.
struct WarmCard {
  double temperature_K = 0;
  Statistics statistics = Statistics::classical;
  double lattice_constant_A = 0;
  double C11_eV_per_A2 = 0, C12_eV_per_A2 = 0;
  double longest_wave_A = 0;  ///< of the flexural waves that count; what longer ones do depends on the drum
};

}  // namespace atomistic
