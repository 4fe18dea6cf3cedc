// JSON forms of the plain structs that cross between the two programs.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

#include "atomistic/problem.hpp"
#include "atomistic/response.hpp"
#include "atomistic/temperature.hpp"

namespace atomistic {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Potential, name, pair_style, pair_coeff, file, kim_model, mass, interaction_range_A,
                                   artefact_bond_A, description, citation)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Card, a0_A, energy_per_atom_eV, C11_eV_per_A2, C12_eV_per_A2, C66_eV_per_A2,
                                   bending_modulus_zigzag_eV, bending_modulus_armchair_eV,
                                   sublattice_stiffness_eV_per_A2, bond_softening, clamp_margin_bonds,
                                   slope_margin_bonds)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(StrainState, E11, E22, E12, orientation_deg)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(HomogeneousState, strain, S11_eV_per_A2, S22_eV_per_A2, S12_eV_per_A2,
                                   energy_eV_per_A2, longest_bond_A, shift_x_A, shift_y_A, converged)

/// A number that JSON cannot hold is null there.
inline double number_or_nan(const nlohmann::json& j) { return j.is_null() ? std::nan("") : j.get<double>(); }

inline void to_json(nlohmann::json& j, const StressCurve& c) {
  j = {{"direction", c.direction},
       {"strain", c.strain},
       {"lateral_strain", c.lateral_strain},
       {"stress_eV_per_A2", c.stress_eV_per_A2},
       {"longest_bond_A", c.longest_bond_A},
       {"secant_2_eV_per_A2", c.secant_2_eV_per_A2},
       {"secant_5_eV_per_A2", c.secant_5_eV_per_A2},
       {"secant_10_eV_per_A2", c.secant_10_eV_per_A2},
       {"strength_eV_per_A2", c.strength_eV_per_A2},
       {"strain_at_strength", c.strain_at_strength},
       {"artefact_strain", c.artefact_strain ? nlohmann::json(*c.artefact_strain) : nlohmann::json(nullptr)}};
}
inline void from_json(const nlohmann::json& j, StressCurve& c) {
  c = {.direction = j.at("direction"),
       .strain = j.at("strain"),
       .lateral_strain = j.at("lateral_strain"),
       .stress_eV_per_A2 = j.at("stress_eV_per_A2"),
       .longest_bond_A = j.at("longest_bond_A"),
       .secant_2_eV_per_A2 = number_or_nan(j.at("secant_2_eV_per_A2")),
       .secant_5_eV_per_A2 = number_or_nan(j.at("secant_5_eV_per_A2")),
       .secant_10_eV_per_A2 = number_or_nan(j.at("secant_10_eV_per_A2")),
       .strength_eV_per_A2 = j.at("strength_eV_per_A2"),
       .strain_at_strength = j.at("strain_at_strength"),
       .artefact_strain =
           j.at("artefact_strain").is_null() ? std::nullopt : std::optional<double>(j["artefact_strain"])};
}
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Response, curves, states)

inline std::vector<double> numbers_of(const Eigen::VectorXd& v) { return {v.data(), v.data() + v.size()}; }
inline Eigen::VectorXd vector_of(const nlohmann::json& j) {
  const auto numbers = j.get<std::vector<double>>();
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}
inline void to_json(nlohmann::json& j, const AtomForces& f) {
  j = {{"energy_eV", f.energy_eV}, {"forces_eV_per_A", numbers_of(f.forces_eV_per_A)}};
}
inline void from_json(const nlohmann::json& j, AtomForces& f) {
  f = {.energy_eV = j.at("energy_eV"), .forces_eV_per_A = vector_of(j.at("forces_eV_per_A"))};
}

NLOHMANN_JSON_SERIALIZE_ENUM(Preconditioning, {{Preconditioning::automatic, "auto"},
                                               {Preconditioning::factor, "factor"},
                                               {Preconditioning::multigrid, "multigrid"}})
NLOHMANN_JSON_SERIALIZE_ENUM(Statistics, {{Statistics::classical, "classical"}, {Statistics::quantum, "quantum"}})
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Heat, temperature_K, statistics, modes)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Mode, eigenvalue_eV_per_A2, frequency_THz, out_of_plane, radius_A, shape)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(HeatedLevel, level, force_eV_per_A, conjugate_depth_A, stable, depth_shift_A,
                                   force_shift_eV_per_A, compliance_A2_per_eV, lowest_eigenvalue_eV_per_A2,
                                   hessian_error_relative, reach_bonds, colours, force_calls, seconds, modes)

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Sampling, temperature_K, length_ps, relative_error, seed)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Sampled, level, stretches, mean_depth_A, error_A, samples, warm_up_ps,
                                   correlation_ps, length_ps, depths_A, positions_A, velocities_A_per_ps)

inline void to_json(nlohmann::json& j, const WarmCard& c) {
  j = {{"temperature_K", c.temperature_K},           {"statistics", c.statistics},
       {"lattice_constant_A", c.lattice_constant_A}, {"C11_eV_per_A2", c.C11_eV_per_A2},
       {"C12_eV_per_A2", c.C12_eV_per_A2},           {"longest_wave_A", c.longest_wave_A}};
}
inline void from_json(const nlohmann::json& j, WarmCard& c) {
  c = {.temperature_K = j.at("temperature_K"),
       .statistics = j.at("statistics"),
       .lattice_constant_A = number_or_nan(j.at("lattice_constant_A")),
       .C11_eV_per_A2 = number_or_nan(j.at("C11_eV_per_A2")),
       .C12_eV_per_A2 = number_or_nan(j.at("C12_eV_per_A2")),
       .longest_wave_A = j.at("longest_wave_A")};
}

NLOHMANN_JSON_SERIALIZE_ENUM(Ended, {{Ended::depth_max, "depth_max"},
                                     {Ended::artefact, "artefact"},
                                     {Ended::rupture, "rupture"},
                                     {Ended::not_converged, "not_converged"}})
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ContactCheck, force_change_relative, depth_change_A,
                                   force_change_at_equal_depth_relative, deepest_penetration_A)

inline void to_json(nlohmann::json& j, const Report& r) {
  j = {{"ended", r.ended},
       {"reason", r.reason},
       {"force_calls", r.force_calls},
       {"force_s", r.force_s},
       {"preconditioning", r.preconditioning},
       {"factor_s", r.factor_s},
       {"solve_s", r.solve_s},
       {"setup_s", r.setup_s},
       {"relaxation_evaluations", r.relaxation_evaluations}};
  if (r.contact) j["contact"] = *r.contact;
}
inline void from_json(const nlohmann::json& j, Report& r) {
  r = {.ended = j.at("ended"),
       .reason = j.at("reason"),
       .contact = j.contains("contact") ? std::optional<ContactCheck>(j["contact"]) : std::nullopt,
       .relaxation_evaluations = j.at("relaxation_evaluations"),
       .force_calls = j.at("force_calls"),
       .force_s = j.at("force_s"),
       .preconditioning = j.at("preconditioning"),
       .factor_s = j.at("factor_s"),
       .solve_s = j.at("solve_s"),
       .setup_s = j.at("setup_s")};
}

}  // namespace atomistic
