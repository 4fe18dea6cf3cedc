// A result as the main job makes it, without running anything: smooth made-up curves of the right size and
// shape.
#pragma once

#include "compare/results/result.hpp"

namespace sample {

/// AIREBO's card (values of physics.md's table), R = 110 Å: two loads as atoms, as membrane with the card's
/// and with the paper's constants. Fitted and judged. The atoms' paths end in the artefact zone.
validate::Result full();

/// One disc run with given constants, no atoms, no card, no verdict.
validate::Result membrane_only();

/// As full(), but the atoms never got anywhere: empty curves, no card, unknown constants.
validate::Result atoms_failed();

/// A curve F = 1.35 E·h δ³/a² × (1 + bending (a/δ)² − softening (δ/a)²) at depths 2, 4, … Å.
validate::Run atomistic_run(validate::LoadKind load, double stiffness, double longest_bond_per_depth);
validate::Run membrane_run(validate::LoadKind load, validate::Constants constants, double stiffness);

}  // namespace sample
