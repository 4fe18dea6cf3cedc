// What a problem that check() accepts for a meridian means there.
#pragma once

#include <limits>
#include <numbers>

#include "membrane/problem.hpp"

namespace membrane::meridian {

inline double radius_A(const Problem& problem) { return std::get<DiscSheet>(problem.sheet).radius_A; }

/// Isotropic.
inline double pretension_eV_per_A2(const Problem& problem) { return problem.prestress_eV_per_A2(0, 0); }

/// 0: a membrane. The Gaussian term does not count where the rim is clamped.
inline double bending_modulus_eV(const Problem& problem) { return problem.bending ? problem.bending->mean_eV : 0; }

/// Moment over angle of the whole rim, eV: κ / margin on each length of it. Infinite: it does not turn.
inline double rim_spring_eV(const Problem& problem) {
  const double margin = std::get<DiscSheet>(problem.sheet).slope_margin_A;
  if (!(margin > 0)) return std::numeric_limits<double>::infinity();
  return 2 * std::numbers::pi * radius_A(problem) * bending_modulus_eV(problem) / margin;
}

/// Force on the whole rim, outwards, eV/Å: dead, and of the edge's own stress.
inline double rim_pull_eV_per_A(const Problem& problem) {
  return 2 * std::numbers::pi * (radius_A(problem) * problem.edge_tension_eV_per_A2 - problem.edge.stress_eV_per_A);
}

/// Of the rim's displacement, eV/Å²: a line of length 2π a that is stretched by u/a.
inline double rim_stiffness_eV_per_A2(const Problem& problem) {
  return 2 * std::numbers::pi * problem.edge.stiffness_eV_per_A / radius_A(problem);
}

/// Energy of the rim's force and stiffness at a displacement outwards, eV.
inline double rim_potential_eV(const Problem& problem, double displacement_A) {
  return (rim_stiffness_eV_per_A2(problem) * displacement_A / 2 - rim_pull_eV_per_A(problem)) * displacement_A;
}

/// What a meridian wants to know of a load beside its pattern.
struct Traits {
  double radius_A = 0;  ///< of the loaded part or the sphere; 0: none
  bool peaked = false;  ///< a membrane comes to a point under it
  bool sphere = false;
  bool pressure = false;  ///< the levels are pressures
};

struct TraitsOf {
  Traits operator()(const CentreForce&) const { return {.peaked = true}; }
  Traits operator()(const SpreadForce& spread) const { return {.radius_A = spread.radius_A}; }
  Traits operator()(const RigidSphere& sphere) const { return {.radius_A = sphere.radius_A, .sphere = true}; }
  Traits operator()(const FollowerPressure&) const { return {.pressure = true}; }
  Traits operator()(const EdgeMotion&) const { return {}; }  // no load of a meridian: check()
};

inline Traits traits_of(const Problem& problem) { return std::visit(TraitsOf{}, action_of(problem.load)); }

}  // namespace membrane::meridian
