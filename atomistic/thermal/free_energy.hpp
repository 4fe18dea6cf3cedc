// Free energy of harmonic vibrations without their frequencies: from determinants.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <optional>

#include "atomistic/thermal/definite_factor.hpp"
#include "atomistic/vibration.hpp"

namespace atomistic {

/// Up to a constant that depends on the number of degrees of freedom, the mass and the temperature alone. eV.
struct VibrationEnergy {
  double free_eV = 0;  ///< of all vibrations
  double held_eV = 0;  ///< of those that leave c·x as it is
};

/// Classical: ½ kT log det H. Quantum: kT Σ log(2 sinh(ħω/2kT)), the product over all Matsubara frequencies
/// 2πnkT/ħ written out,
///   ½ kT log det H + kT Σ_{n≥1} log det(1 + H/s_n),   s_n = m (2πn kT/ħ)²,
/// its tail by the traces of H and H². Vibrations that leave c·x as it is have log det H + log cᵀH⁻¹c in place of
/// log det H, for each determinant.
class VibrationalFreeEnergy {
 public:
  VibrationalFreeEnergy(const Heat& heat, double mass_u);

  /// Of a symmetric Hessian (eV/Å², one mass); c may be empty, then held_eV is free_eV. Nothing if it is not positive
  /// definite. The factor of H is left in `factor`.
  std::optional<VibrationEnergy> operator()(const Eigen::SparseMatrix<double>& hessian, const Eigen::VectorXd& c,
                                            DefiniteFactor& factor) const;

 private:
  VibrationEnergy quantum_part(const Eigen::SparseMatrix<double>& hessian, const Eigen::VectorXd& c) const;

  double kT_eV_;
  Statistics statistics_;
  double first_shift_eV_per_A2_;  ///< s_1
};

/// Largest eigenvalue of a symmetric matrix, from below within some per cent.
double largest_eigenvalue(const Eigen::SparseMatrix<double>& matrix);

}  // namespace atomistic
