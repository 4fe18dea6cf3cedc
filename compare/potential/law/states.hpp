// The homogeneous strains that a law is calibrated to.
#pragma once

#include <vector>

#include "atomistic/response.hpp"

namespace validate {

/// Up to which longest bond a calibrated law holds, and up to which states it is fitted: a little beyond, short of the
/// potential's switching function.
struct CalibrationRange {
  double holds_A = 1.66, fitted_A = 1.68;
};

/// As far as the potential bears: 0.04 and 0.02 Å short of its artefact length, and never beyond 1.88 and 1.90 Å, where
/// no carbon bond is left to calibrate to.
CalibrationRange calibration_range(double artefact_bond_A);

/// Angles from zigzag at which the sixfold part of the response is largest one way, nothing, and largest the other way.
inline constexpr double zigzag_deg = 0, averaged_deg = 15, armchair_deg = 30;

/// Every pair of principal stretches, from 0.97 to the one that brings a bond of this length (Å, at rest) to where the
/// law shall hold, at the three angles (equibiaxial ones once): of eleven stretches, 176 states, up to 1.66 Å, and more
/// beyond, as dense as those before.
std::vector<atomistic::StrainState> calibration_strains(double bond_A, const CalibrationRange& range);

/// Size of a state's membrane force, eV/Å², which misfits are relative to; never below 0.1, so that small forces do not
/// count for more than they mean.
double size_of(const atomistic::HomogeneousState& state);

}  // namespace validate
