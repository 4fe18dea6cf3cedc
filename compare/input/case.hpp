// The case: what the user asks for, in base units, after the input file and the flags have been merged.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/base/describe.hpp"
#include "compare/base/field_value.hpp"

namespace validate {

inline constexpr std::array<std::string_view, 3> load_names = {"point", "disc", "sphere"};
inline constexpr std::array<std::string_view, 2> centre_names = {"hexagon", "atom"};
inline constexpr std::array<std::string_view, 2> continuum_names = {"sheet", "membrane"};
inline constexpr std::array<std::string_view, 3> model_names = {"membrane", "atomistic", "both"};

struct Case {
  double radius_A = 110;
  std::string potential = "airebo";
  std::vector<std::string> loads = {"point", "disc"};
  double tip_radius_A = 10;
  std::optional<double> depth_max_A;    ///< absent: 0.22 × radius
  std::optional<double> depth_step_A;   ///< absent: 2 Å; radius / 55 for a membrane of given constants
  std::vector<double> forces_eV_per_A;  ///< replaces the depth list when not empty
  double pretension_eV_per_A2 = 0;
  std::string models = "both";  ///< membrane | atomistic | both

  // [membrane] constants given by the user: all three or none
  std::optional<double> E_eV_per_A3, thickness_A, nu;

  // [atomistic]
  double force_tolerance_eV_per_A = 1e-5;
  bool past_artefact = false;
  bool unloading = false;                          ///< back through the depths that were reached
  std::optional<double> switch_length_A;           ///< absent: the potential as it is
  std::string centre = "hexagon";                  ///< what the axis goes through: hexagon | atom
  double rotation_deg = 0;                         ///< of the lattice
  std::vector<double> vacancies_A, stone_wales_A;  ///< places x, y, x, y, …

  // [agreement]
  std::string judged_load = "disc";
  std::string against = "sheet";  ///< sheet: calibrated, with bending; membrane: the paper's law, card constants
  std::vector<double> window = {0.03, 0.5};  ///< depth / effective radius
  double window_bond_A = 1.65;               ///< the window ends where the atoms' longest bond is this, if earlier
  double tolerance = 0.01;
  double regime_tolerance = 0.06;  ///< force ratio beyond which bending or softening is spoken of
};

template <class Self, class Visitor>
requires SameStruct<Self, Case>
void describe(Self& c, Visitor&& visit) {
  visit(Field{"radius", unit::length, "radius of the free sheet", positive()}, c.radius_A);
  visit(Field{"potential", {}, "name in inputs/potentials, or path to a TOML file"}, c.potential);
  visit(Field{.name = "loads", .meaning = "loads to run, separated by commas", .choices = load_names}, c.loads);
  visit(Field{"tip-radius", unit::length, "radius of the loaded disc and of the sphere", positive()}, c.tip_radius_A);
  visit(Field{"depth-max", unit::length, "largest depth (0.22 of the radius if not given)", positive()}, c.depth_max_A);
  visit(Field{"depth-step", unit::length, "distance between depths (2 Å; radius/55 for given constants)", positive()},
        c.depth_step_A);
  visit(Field{"forces", unit::force, "dead-load levels instead of depths", positive()}, c.forces_eV_per_A);
  visit(Field{"pretension", unit::membrane_force, "isotropic membrane force of the flat sheet", not_negative()},
        c.pretension_eV_per_A2);
  visit(Field{.name = "models", .meaning = "which models to run", .choices = model_names}, c.models);

  visit(Field{"E", unit::stress, "Young's modulus of a membrane with given constants", positive(), "membrane"},
        c.E_eV_per_A3);
  visit(Field{"thickness", unit::length, "thickness that goes with E", positive(), "membrane"}, c.thickness_A);
  visit(Field{"nu", {}, "Poisson's ratio that goes with E", between(-1, 1), "membrane"}, c.nu);

  visit(Field{"force-tolerance", unit::force, "largest force left on a free atom", from_to(1e-9, 1e-2), "atomistic"},
        c.force_tolerance_eV_per_A);
  visit(Field{"past-artefact", {}, "go on past the bond length where forces are an artefact", {}, "atomistic"},
        c.past_artefact);

  visit(Field{"unloading", {}, "go back through the depths that were reached", {}, "atomistic"}, c.unloading);
  visit(Field{"switch-length", unit::length, "move the C-C switch of AIREBO or REBO there, in a copy of its file",
              from_to(1.70, 1.99), "atomistic"},
        c.switch_length_A);
  visit(Field{"centre", {}, "what the axis goes through", {}, "atomistic", centre_names}, c.centre);
  visit(Field{"rotation-deg", {}, "turns the lattice, degrees", from_to(-360, 360), "atomistic"}, c.rotation_deg);
  visit(Field{"vacancies", unit::length, "places x,y,x,y,... whose nearest atom is missing", {}, "atomistic"},
        c.vacancies_A);
  visit(Field{"stone-wales",
              unit::length,
              "places x,y,x,y,... whose nearest bond is turned by 90 degrees",
              {},
              "atomistic"},
        c.stone_wales_A);

  visit(Field{"judged-load", {}, "load whose curves the verdict compares", {}, "agreement", load_names}, c.judged_load);
  visit(Field{"against", {}, "continuum that the atoms are held against", {}, "agreement", continuum_names}, c.against);
  visit(Field{"window", {}, "judged range of depth / effective radius", between(0, 1), "agreement"}, c.window);
  visit(Field{"window-bond", unit::length, "longest bond at which the judged range ends, if before its upper end",
              from_to(1.3, 3), "agreement"},
        c.window_bond_A);
  visit(Field{"tolerance", {}, "largest relative force difference that passes", positive(), "agreement"}, c.tolerance);
  visit(Field{"regime-tolerance",
              {},
              "force ratio to the membrane beyond which bending or softening begins",
              positive(),
              "agreement"},
        c.regime_tolerance);
}

/// True when E, thickness and nu are given: a membrane alone, without card, atoms or verdict.
bool has_given_constants(const Case&);

/// Largest controlled depth: the one given, else 0.22 × radius. Å.
double largest_depth_A(const Case&);

/// Distance between controlled depths: the one given, else 2 Å, and for a membrane of given constants, which may be of
/// any size, what that is at 110 Å: radius / 55. Å.
double depth_step_A(const Case&);

/// Controlled depths in Å: step, 2 step, … and the largest depth itself as the last one. Not used with
/// forces.
std::vector<double> depth_levels(const Case&);

/// Relations between fields, which a field's own range cannot express. Returns warnings; an impossible case
/// throws Error (bad input) that names the key and, from the origins, its file and line or its flag.
std::vector<std::string> check(const Case&, const Origins& origins = {});

}  // namespace validate
