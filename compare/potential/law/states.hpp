// The homogeneous strains that a law is calibrated to.
#pragma once

#include <vector>

#include "atomistic/response.hpp"

namespace validate {

/// A calibrated law holds up to this longest bond, Å …
inline constexpr double longest_calibrated_bond_A = 1.66;
/// … and is fitted to states a little beyond, short of the switching functions of the potentials.
inline constexpr double longest_fitted_bond_A = 1.68;

/// Angles from zigzag at which the sixfold part of the response is largest one way, nothing, and largest the other way.
inline constexpr double zigzag_deg = 0, averaged_deg = 15, armchair_deg = 30;

/// Every pair of eleven principal stretches, from 0.97 to the one that brings a bond of this length (Å, at rest) to
/// longest_calibrated_bond_A, at the three angles (equibiaxial ones once): 176 states.
std::vector<atomistic::StrainState> calibration_strains(double bond_A);

/// Size of a state's membrane force, eV/Å², which misfits are relative to; never below 0.1, so that small forces do not
/// count for more than they mean.
double size_of(const atomistic::HomogeneousState& state);

}  // namespace validate
