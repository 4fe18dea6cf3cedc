#include "compare/input/case.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "compare/base/errors.hpp"
#include "compare/base/units.hpp"

namespace validate {
namespace {

constexpr double depth_max_of_radius = 0.22;
constexpr int most_levels = 10000;

// Bounds of an atomistic sheet. The lattice constant is that of graphene, since the card is not known yet.
constexpr double lattice_constant_A = 2.46;
constexpr double smallest_atomistic_radius_A = 3 * lattice_constant_A;
constexpr double smallest_atomistic_tip_A = 1.5;      // just holds the central hexagon
constexpr double largest_atomistic_radius_A = 3000;   // 10.8 million atoms
constexpr double largest_pressed_radius_A = 1000;     // under a pressure: 1.5 million atoms in a square
constexpr double laboratory_radius_A = 1000;          // a drum
constexpr double largest_pretension_eV_per_A2 = 2.6;  // 42 N/m, the breaking strength of graphene

// Bounds of any sheet: beyond them a unit was mistaken, and the mesh or the solver would say so less clearly.
constexpr double largest_rim_strain = 0.1;  // of the rim's tension over E·h
constexpr double largest_tip_of_radius = 0.95, smallest_tip_of_radius = 1e-6;
constexpr double smallest_radius_A = 1e-3, largest_radius_A = 1e14;           // up to 10 km
constexpr double smallest_Eh_eV_per_A2 = 1e-12, largest_Eh_eV_per_A2 = 1e12;  // 16 pN/m, 16 TN/m

/// Loads that the tip radius describes.
bool has_tip(const Case& c) { return has_load(c, LoadKind::disc) || has_load(c, LoadKind::sphere); }

/// Loads that press at the centre: they have depths as levels, or dead forces.
bool has_indenter(const Case& c) { return has_tip(c) || has_load(c, LoadKind::point); }

void check_loads(const Case& c, const Origins& origins) {
  if (c.loads.empty()) throw bad_input("{}: at least one load is needed", label_of(origins, "loads"));
  for (auto load = c.loads.begin(); load != c.loads.end(); ++load) {
    if (std::find(c.loads.begin(), load, *load) != load) {
      throw bad_input("{}: '{}' is named twice", label_of(origins, "loads"), to_string(*load));
    }
  }
  if (has_indenter(c) && c.shape != Shape::disc)
    throw bad_input("{}: an indenter presses a disc; a square takes the load 'pressure' alone",
                    label_of(origins, "shape"));
  if (has_indenter(c) && c.edge == Edge::sliding && !c.rim_tension_eV_per_A2)
    throw bad_input(
        "{}: a rim that slides bears no indenter unless something pulls it outwards: give rim-tension, for instance "
        "\"0.3 N/m\", or let it be clamped; under the load 'pressure' alone it needs none",
        label_of(origins, c.rim ? "rim" : "edge"));
  if (!has_tip(c)) return;
  if (!(c.tip_radius_A <= largest_tip_of_radius * c.radius_A)) {
    throw bad_input("{}: a tip of {} Å is wider than the sheet can take; at most {} of its radius of {} Å: {:.6g} Å",
                    label_of(origins, "tip-radius"), c.tip_radius_A, largest_tip_of_radius, c.radius_A,
                    largest_tip_of_radius * c.radius_A);
  }
  if (!(c.tip_radius_A >= smallest_tip_of_radius * c.radius_A)) {
    throw bad_input("{}: a tip of {} Å is too small for a radius of {} Å; at least {} of it, or the point load",
                    label_of(origins, "tip-radius"), c.tip_radius_A, c.radius_A, smallest_tip_of_radius);
  }
}

/// A dead tension has work to do only where the rim gives way, and nothing else may bear or push.
void check_rim_tension(const Case& c, const Origins& origins) {
  if (c.relaxed && c.unrelaxed)
    throw bad_input("{}, {}: they exclude each other", label_of(origins, "relaxed"), label_of(origins, "unrelaxed"));
  if (!c.rim_tension_eV_per_A2) return;
  if (c.edge != Edge::sliding || c.shape != Shape::disc)
    throw bad_input("{}: only the rim of a disc that slides in its plane can be pulled; add rim = \"sliding\"",
                    label_of(origins, "rim-tension"));
  if (has_load(c, LoadKind::pressure))
    throw bad_input("{}: beside a pressure a rim is not pulled; leave 'pressure' out of the loads",
                    label_of(origins, "rim-tension"));
  const double most =
      has_given_constants(c) ? largest_rim_strain * *c.E_eV_per_A3 * *c.thickness_A : largest_pretension_eV_per_A2;
  if (!(*c.rim_tension_eV_per_A2 <= most))
    throw bad_input("{}: {} eV/Å² would tear the sheet before the test; at most {:.6g} eV/Å² ({:.4g} N/m)",
                    label_of(origins, "rim-tension"), *c.rim_tension_eV_per_A2, most, most * N_per_m_per_eV_per_A2);
}

void check_given_constants(const Case& c, const Origins& origins) {
  const std::pair<std::string_view, bool> constants[] = {
      {"E", c.E_eV_per_A3.has_value()}, {"thickness", c.thickness_A.has_value()}, {"nu", c.nu.has_value()}};
  std::string given, missing;
  for (const auto& [name, is_given] : constants) {
    std::string& list = is_given ? given : missing;
    list += (list.empty() ? "" : ", ") + (is_given ? label_of(origins, name) : std::string(name));
  }
  const bool thickness_alone = c.thickness_A && !c.E_eV_per_A3 && !c.nu;  // what stresses are over
  if (!c.potential.empty() && (given.empty() || thickness_alone)) return;
  if (!missing.empty()) {
    throw bad_input("{}: a membrane with given constants needs E, thickness and nu; missing: {}",
                    given.empty() ? label_of(origins, "potential") : given, missing);
  }
  if (!c.potential.empty() && c.models != Models::membrane) {
    throw bad_input("{}: given constants describe a membrane alone: add --models membrane ({} is '{}')", given,
                    label_of(origins, "models"), to_string(c.models));
  }
}

void check_whole(const Case& c, const Origins& origins) {
  if (c.cells && *c.cells != std::floor(*c.cells))
    throw bad_input("{}: {} is not a whole number", label_of(origins, "cells"), *c.cells);
  if (c.pretension_eV_per_A2 > 0 && c.edge == Edge::sliding)
    throw bad_input("{}: an edge that slides cannot hold a pretension; use edge = \"clamped\"",
                    label_of(origins, "pretension"));
  if (c.shape == Shape::disc && c.edge == Edge::sliding && c.extent == Extent::full && !c.rim_tension_eV_per_A2)
    throw bad_input("{}: a full disc with a sliding rim can turn in its plane; use extent = \"quarter\"",
                    label_of(origins, "extent"));
}

/// A level that is reached already asks for nothing.
void check_different(std::vector<double> levels, std::string_view name, std::string_view unit, const Origins& origins) {
  constexpr double same = 1e-9;
  std::sort(levels.begin(), levels.end());
  const auto equal = [](double a, double b) { return b - a <= same * std::abs(b); };
  if (const auto twice = std::adjacent_find(levels.begin(), levels.end(), equal); twice != levels.end())
    throw bad_input("{}: {} {} is named twice", label_of(origins, name), *twice, unit);
}

void check_pressures(const Case& c, const Origins& origins) {
  if (!has_load(c, LoadKind::pressure)) return;
  if (c.pressures_eV_per_A3.empty())
    throw bad_input("{}: at least one pressure is needed", label_of(origins, "pressures"));
  check_different(c.pressures_eV_per_A3, "pressures", "eV/Å³", origins);
  if (!c.potential.empty() && c.models != Models::membrane && !(c.radius_A <= largest_pressed_radius_A))
    throw bad_input("{}: {} Å is too large for a sheet of atoms; at most {} Å",
                    label_of(origins, c.size_A ? "size" : "radius"), 2 * c.radius_A, 2 * largest_pressed_radius_A);
  constexpr double graphene_eV_per_A2 = 8;  // of a potential whose card is not known yet: no potential is softer
  const double Eh = has_given_constants(c) ? *c.E_eV_per_A3 * *c.thickness_A : graphene_eV_per_A2;
  for (const double p : c.pressures_eV_per_A3)
    if (!(p * 2 * c.radius_A <= 0.5 * Eh))
      throw bad_input("{}: {} eV/Å³ over {} Å is beyond half of E × thickness: no such sheet stays whole",
                      label_of(origins, "pressures"), p, 2 * c.radius_A);
}

void check_law(const Case& c, const Origins& origins) {
  if (c.models == Models::atomistic && c.law.is_chosen())
    throw bad_input("{}: '{}' is the law of a membrane, and {} is 'atomistic'", label_of(origins, "law"), c.law.name,
                    label_of(origins, "models"));
  constexpr double any_Eh_eV_per_A2 = 20, any_nu = 0.2;  // of a potential whose card is not known yet
  if (has_given_constants(c))
    law_of(c.law, *c.E_eV_per_A3 * *c.thickness_A, *c.nu, origins);
  else
    law_of(c.law, any_Eh_eV_per_A2, any_nu, origins);
}

/// What a membrane of given constants can be and bear, in terms of its own modulus.
void check_membrane(const Case& c, const Origins& origins) {
  const double Eh = *c.E_eV_per_A3 * *c.thickness_A;
  if (!(c.radius_A >= smallest_radius_A && c.radius_A <= largest_radius_A)) {
    throw bad_input("{}: {:g} Å is no radius of a membrane; allowed: {:g} Å to {:g} Å", label_of(origins, "radius"),
                    c.radius_A, smallest_radius_A, largest_radius_A);
  }
  if (!(Eh >= smallest_Eh_eV_per_A2 && Eh <= largest_Eh_eV_per_A2)) {
    throw bad_input("{}, {}: E times thickness is {} eV/Å²; allowed: {:g} to {:g}", label_of(origins, "E"),
                    label_of(origins, "thickness"), Eh, smallest_Eh_eV_per_A2, largest_Eh_eV_per_A2);
  }
  if (!(c.pretension_eV_per_A2 <= Eh)) {
    throw bad_input("{}: {} eV/Å² is more than E times thickness, {:.6g} eV/Å²", label_of(origins, "pretension"),
                    c.pretension_eV_per_A2, Eh);
  }
  for (const double force : c.forces_eV_per_A) {
    if (!(force <= Eh * c.radius_A)) {
      throw bad_input(
          "{}: {} eV/Å would press the sheet deeper than its radius; at most E times thickness times radius, "
          "{:.6g} eV/Å",
          label_of(origins, "forces"), force, Eh * c.radius_A);
    }
  }
}

void check_lattice(const Case& c, const Origins& origins) {
  if (!(c.radius_A >= smallest_atomistic_radius_A)) {
    const double times = c.size_A ? 2 : 1;  // in the words of the user
    throw bad_input("{}: {} Å is too small for a sheet of atoms; at least {} lattice constants, {:.2f} Å",
                    label_of(origins, c.size_A ? "size" : "radius"), times * c.radius_A, c.size_A ? "six" : "three",
                    times * smallest_atomistic_radius_A);
  }
  if (c.models != Models::membrane && !(c.radius_A <= largest_atomistic_radius_A)) {
    throw bad_input(
        "{}: {} Å is too large for a sheet of atoms; at most {} Å (10.8 million atoms), "
        "or --models membrane",
        label_of(origins, "radius"), c.radius_A, largest_atomistic_radius_A);
  }
  if (has_tip(c) && !(c.tip_radius_A >= smallest_atomistic_tip_A)) {
    throw bad_input("{}: a tip of {} Å meets no atom; at least {} Å, the size of the central hexagon",
                    label_of(origins, "tip-radius"), c.tip_radius_A, smallest_atomistic_tip_A);
  }
  if (!(c.pretension_eV_per_A2 <= largest_pretension_eV_per_A2)) {
    throw bad_input("{}: {} eV/Å² would break the sheet before the test; at most {} eV/Å² (42 N/m)",
                    label_of(origins, "pretension"), c.pretension_eV_per_A2, largest_pretension_eV_per_A2);
  }
  const double largest_force = 2 * std::numbers::pi * c.radius_A * largest_pretension_eV_per_A2;
  for (const double force : c.forces_eV_per_A) {
    if (!(force <= largest_force)) {
      throw bad_input("{}: {} eV/Å would tear the sheet off its rim; at most 42 N/m around it, {:.6g} eV/Å",
                      label_of(origins, "forces"), force, largest_force);
    }
  }
}

void check_levels(const Case& c, const Origins& origins) {
  if (!has_indenter(c)) return;
  if (c.forces_eV_per_A.size() > most_levels) {
    throw bad_input("{}: {} levels are too many; at most {}", label_of(origins, "forces"), c.forces_eV_per_A.size(),
                    most_levels);
  }
  check_different(c.forces_eV_per_A, "forces", "eV/Å", origins);
  if (!c.forces_eV_per_A.empty()) return;
  const double depth_max = largest_depth_A(c);
  if (!(depth_max <= c.radius_A)) {
    throw bad_input("{}: {} Å is deeper than the radius, {} Å", label_of(origins, "depth-max"), depth_max, c.radius_A);
  }
  if (!(depth_step_A(c) <= depth_max)) {
    throw bad_input("{}: {} Å is larger than the largest depth, {:.6g} Å{}", label_of(origins, "depth-step"),
                    depth_step_A(c), depth_max,
                    c.depth_max_A ? "" : fmt::format(" ({} of the radius)", depth_max_of_radius));
  }
  if (!(depth_max / depth_step_A(c) <= most_levels)) {
    throw bad_input("{}: steps of {} Å up to {:.6g} Å are {:.0f} levels; at most {}", label_of(origins, "depth-step"),
                    depth_step_A(c), depth_max, depth_max / depth_step_A(c), most_levels);
  }
}

/// Below this the force of a sheet of atoms, 16π κ δ/a² as long as it is bent alone, is not ten times what an
/// equilibrium may leave on one atom, and the curve is noise.
double smallest_depth_A(const Case& c) {
  constexpr double tolerance_eV_per_A = 1e-5, softest_kappa_eV = 1, never_larger_A = 0.05;
  return std::min(never_larger_A,
                  10 * tolerance_eV_per_A * c.radius_A * c.radius_A / (16 * std::numbers::pi * softest_kappa_eV));
}

void check_resolved(const Case& c, const Origins& origins) {
  constexpr double smallest_force_eV_per_A = 1e-4;
  if (!has_indenter(c) || has_given_constants(c) || c.models == Models::membrane) return;
  for (const double force : c.forces_eV_per_A)
    if (!(force >= smallest_force_eV_per_A))
      throw bad_input("{}: {} eV/Å is no more than what equilibria leave; at least {} eV/Å",
                      label_of(origins, "forces"), force, smallest_force_eV_per_A);
  if (c.forces_eV_per_A.empty() && !(depth_step_A(c) >= smallest_depth_A(c)))
    throw bad_input("{}: the forces of a sheet of {} Å do not resolve {} Å; at least {:.2g} Å",
                    label_of(origins, c.depth_step_A ? "depth-step" : "depth-max"), c.radius_A, depth_step_A(c),
                    smallest_depth_A(c));
}

void check_places(const std::vector<double>& places, std::string_view name, const Case& c, const Origins& origins) {
  if (places.size() % 2 != 0)
    throw bad_input("{}: {} numbers are not pairs x,y", label_of(origins, name), places.size());
  for (std::size_t i = 0; i + 1 < places.size(); i += 2)
    if (!(std::hypot(places[i], places[i + 1]) < c.radius_A))
      throw bad_input("{}: the place {}, {} Å lies outside the free sheet, whose radius is {} Å",
                      label_of(origins, name), places[i], places[i + 1], c.radius_A);
}

void check_window(const Case& c, const Origins& origins) {
  const bool increasing = c.window.size() == 2 && c.window[0] < c.window[1];
  if (!increasing) {
    throw bad_input("{}: the window must be two increasing numbers, for instance 0.10, 0.15",
                    label_of(origins, "window"));
  }
}

std::vector<std::string> warnings(const Case& c, const Origins& origins) {
  std::vector<std::string> found;
  if (!c.forces_eV_per_A.empty()) {
    if (c.depth_max_A) {
      found.push_back(label_of(origins, "depth-max") + ": not used, because forces are given");
    }
  } else if (has_indenter(c) && largest_depth_A(c) >= c.radius_A / 2) {
    found.push_back(fmt::format("{}: {:.6g} Å is half of the radius or more: a sheet is torn long before",
                                label_of(origins, "depth-max"), largest_depth_A(c)));
  }
  return found;
}

/// Quantum statistics of a temperature sum over all multiples of it up to the stiffest vibration's.
constexpr double lowest_quantum_temperature_K = 10;

/// A temperature is the atoms': of a clamped sheet, whose vibrations are known.
void check_temperature(const Case& c, const Origins& origins) {
  if (!c.temperature_K) {
    for (const char* name : {"statistics", "modes", "sample", "error", "seed"})
      if (origins.contains(name))
        throw bad_input("{}: it belongs to a temperature, and none is given", label_of(origins, name));
    if (c.rim == Rim::thermal || c.rim == Rim::at_rest)
      throw bad_input("{}: '{}' belongs to a temperature, and none is given", label_of(origins, "rim"),
                      to_string(*c.rim));
    return;
  }
  const std::string label = label_of(origins, "temperature");
  if (c.models == Models::membrane || has_given_constants(c))
    throw bad_input("{}: a temperature is the atoms', and none are asked for", label);
  if (c.edge == Edge::sliding)
    throw bad_input("{}: the vibrations of a sheet whose edge slides are not computed; use edge = \"clamped\"", label);
  if (c.statistics == Statistics::quantum && *c.temperature_K < lowest_quantum_temperature_K)
    throw bad_input("{}: {} K is too low for quantum statistics; at least {} K", label, *c.temperature_K,
                    lowest_quantum_temperature_K);
  for (const auto& [name, value] : {std::pair("modes", c.modes), std::pair("seed", c.seed)})
    if (value != std::floor(value)) throw bad_input("{}: {} is not a whole number", label_of(origins, name), value);
  if (!c.sample_ps) return;
  if (!(*c.temperature_K > 0))
    throw bad_input("{}: at 0 K there is no dynamics to sample", label_of(origins, "sample"));
  if (has_load(c, LoadKind::sphere) || has_load(c, LoadKind::pressure))
    throw bad_input("{}: dynamics is sampled under a dead force, of the loads point and disc",
                    label_of(origins, "sample"));
}

}  // namespace

Case bulge_defaults() {
  Case c;
  c.shape = Shape::square;
  c.edge = Edge::sliding;
  c.potential.clear();
  c.loads = {LoadKind::pressure};
  c.pressures_eV_per_A3 = {paper::pressure_eV_per_A3};
  c.cells = 60;
  return c;
}

void settle_units(Case& c, const std::vector<std::string>& values_given) {
  if (c.units != Units::automatic) return;
  const bool asked = std::ranges::any_of(values_given, in_laboratory_units);
  const bool drum = has_given_constants(c) && c.radius_A >= laboratory_radius_A;
  c.units = asked || drum ? Units::laboratory : Units::atomic;
}

void settle_size(Case& c, const Origins& origins) {
  if (!c.size_A) return;
  const auto by_flag = [&](const char* name) { return label_of(origins, name).starts_with("--"); };
  if (origins.contains("radius") && by_flag("radius") == by_flag("size"))
    throw bad_input("{}, {}: radius and size say the same thing; give one", label_of(origins, "radius"),
                    label_of(origins, "size"));
  if (origins.contains("radius") && by_flag("radius"))
    c.size_A.reset();
  else
    c.radius_A = *c.size_A / 2;
}

void settle_rim(Case& c, const Origins& origins) {
  if (!c.rim) return;
  if (c.shape != Shape::disc)
    throw bad_input("{}: a {} has no rim; its key is edge", label_of(origins, "rim"), to_string(c.shape));
  const Edge edge = *c.rim == Rim::sliding ? Edge::sliding : Edge::clamped;
  if (origins.contains("edge") && c.edge != edge)
    throw bad_input("{}, {}: edge and rim say different things of the same rim; give one", label_of(origins, "edge"),
                    label_of(origins, "rim"));
  c.edge = edge;
}

bool has_pulled_rim(const Case& c) { return c.rim_tension_eV_per_A2.has_value(); }

bool has_load(const Case& c, LoadKind load) { return std::ranges::find(c.loads, load) != c.loads.end(); }

bool has_given_constants(const Case& c) { return c.E_eV_per_A3 && c.thickness_A && c.nu; }

double largest_depth_A(const Case& c) { return c.depth_max_A.value_or(depth_max_of_radius * c.radius_A); }

double depth_step_A(const Case& c) {
  constexpr double step_A = 2, reference_radius_A = paper::radius_A;
  if (c.depth_step_A) return *c.depth_step_A;
  if (has_given_constants(c)) return step_A / reference_radius_A * c.radius_A;
  return std::min(step_A, largest_depth_A(c));
}

std::vector<double> depth_levels(const Case& c) {
  constexpr double same = 1e-9;  // relative; a last step shorter than this is rounding
  const double depth_max = largest_depth_A(c), step = depth_step_A(c);
  std::vector<double> levels;
  for (int i = 1; i * step < depth_max * (1 - same); ++i) levels.push_back(i * step);
  levels.push_back(depth_max);
  return levels;
}

std::vector<std::string> check(const Case& c, const Origins& origins) {
  check_given_constants(c, origins);
  if (has_given_constants(c)) {
    check_membrane(c, origins);
  } else {
    check_lattice(c, origins);
  }
  check_law(c, origins);
  check_loads(c, origins);
  check_whole(c, origins);
  check_rim_tension(c, origins);
  check_pressures(c, origins);
  check_levels(c, origins);
  check_resolved(c, origins);
  check_places(c.vacancies_A, "vacancies", c, origins);
  check_places(c.stone_wales_A, "stone-wales", c, origins);
  check_window(c, origins);
  check_temperature(c, origins);
  return warnings(c, origins);
}

}  // namespace validate
