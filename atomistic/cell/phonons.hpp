// Vibrations of the flat periodic sheet under homogeneous strain, and what they add to its free energy.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "atomistic/problem.hpp"
#include "atomistic/temperature.hpp"

namespace atomistic {

/// The force constants of a homogeneous state, sampled on wave vectors; eigenvalues of the Hessian (eV/Å²).
struct PhononSample {
  double wave_per_A = 0;                 ///< |q| in the unstrained sheet
  std::vector<double> others_eV_per_A2;  ///< the four in the plane, and the optical one out of it
  double flexural_eV_per_A2 = 0;
};

/// On an n × n mesh of the Brillouin zone that leaves out its centre, those of a pair q, −q once. The strain is in the
/// sheet's axes (zigzag along x), the sublattices are relaxed. On the calling rank alone.
std::vector<PhononSample> phonons(const Potential& potential, const Card& card, const Eigen::Matrix2d& strain, int mesh,
                                  const std::string& log_file);

/// Free energy per reference area (eV/Å²) of the phonons, up to a constant that the strain does not change. Flexural
/// waves longer than 2π/shortest_q are left out, smoothly: with the weight 1 − exp(−(q/shortest_q)⁴). NaN where a
/// vibration that counts is unstable.
double phonon_free_energy(const std::vector<PhononSample>& samples, const Card& card, double mass_u, const Heat& heat,
                          double shortest_q_per_A);

}  // namespace atomistic
