// A load of the case as each model knows it.
#pragma once

#include "atomistic/problem.hpp"
#include "compare/input/case.hpp"
#include "compare/pairing/sheet.hpp"
#include "membrane/problem.hpp"

namespace validate {

/// As the atoms know it. `point` is the six atoms of the central hexagon.
atomistic::Load atoms_load(const Case& c, LoadKind load);

/// On a membrane that has no atoms to match: radii as the case names them, the point one node.
membrane::Load nominal_load(const Case& c, LoadKind load);

/// The membrane's load that belongs to the atoms'. Dead loads on N atoms have a disc of their area as twin, a rigid
/// sphere the same sphere: its radius is to the atoms' centres.
membrane::Load twin_of(const Case& c, const PairedSheet& pair, LoadKind load);

/// Of the loaded disc or the sphere; 0: a point; NaN: no tip.
double tip_radius_A(const membrane::Load& load);

/// Whether levels are forces or pressures, not depths.
bool prescribes_force(const Case& c, LoadKind load);

}  // namespace validate
