// A result as the main job makes it, without running anything: smooth made-up curves of the right size and
// shape.
#pragma once

#include "compare/result.hpp"

namespace sample {

/// AIREBO's card (values of physics.md's table), R = 110 Å: two loads as atoms, as membrane with the card's
/// and with the paper's constants. Fitted and judged. The atoms' paths end in the artefact zone.
compare::Result full();

/// One disc run with given constants, no atoms, no card, no verdict.
compare::Result membrane_only();

/// As full(), but the atoms never got anywhere: empty curves, no card, unknown constants.
compare::Result atoms_failed();

/// A curve F = 1.35 E·h δ³/a² × (1 + bending (a/δ)² − softening (δ/a)²) at depths 2, 4, … Å.
compare::Run atomistic_run(const std::string& load, double stiffness, double longest_bond_per_depth);
compare::Run membrane_run(const std::string& load, compare::Constants constants, double stiffness);

}  // namespace sample
