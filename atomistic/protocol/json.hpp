// JSON forms of the plain structs that cross between the two programs.
#pragma once

#include <nlohmann/json.hpp>

#include "atomistic/problem.hpp"

namespace atomistic {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Potential, name, pair_style, pair_coeff, file, mass, interaction_range_A,
                                   artefact_bond_A, description, citation)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Card, a0_A, energy_per_atom_eV, C11_eV_per_A2, C12_eV_per_A2,
                                   C66_eV_per_A2, bending_modulus_zigzag_eV, bending_modulus_armchair_eV,
                                   sublattice_stiffness_eV_per_A2, bond_softening)
NLOHMANN_JSON_SERIALIZE_ENUM(Ended, {{Ended::depth_max, "depth_max"},
                                     {Ended::artefact, "artefact"},
                                     {Ended::rupture, "rupture"},
                                     {Ended::not_converged, "not_converged"}})
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Report, ended, reason, force_calls, force_s, factor_s, solve_s, setup_s)

}  // namespace atomistic
