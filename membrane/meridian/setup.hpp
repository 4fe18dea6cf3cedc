// From a problem to what is solved: terms, held degrees of freedom, load pattern, first guesses.
#pragma once

#include <Eigen/Core>

#include "membrane/meridian/assembly.hpp"
#include "membrane/problem.hpp"

namespace membrane::meridian {

/// Places of the terms in the assembly.
enum : int { stretching_term, bending_term, pressure_term };

/// Throws std::invalid_argument where the law cannot carry the pretension.
Assembly assembly_of(const Problem& problem);

/// Weights over the degrees of freedom whose product with x is the load's conjugate depth; empty for sphere
/// and pressure.
Eigen::VectorXd pattern_of(const Problem& problem, const Assembly& assembly);

/// The load's conjugate depth of a shape: the pattern's, or else the depth at the centre.
double conjugate_depth(const Eigen::VectorXd& pattern, const Eigen::VectorXd& x);

/// The flat sheet stretched as Hooke's law says of the rim's tension.
Eigen::VectorXd evenly_stretched(const Problem& problem, const Assembly& assembly);

/// Schwerin's shape 1 − (ρ/ρ_a)^(2/3), ρ² = r² + c², at a conjugate depth of one; c is the load's radius.
Eigen::VectorXd tip_shape(const Problem& problem, const Assembly& assembly, const Eigen::VectorXd& pattern);

/// A paraboloid of about the depth that Hencky's solution has at this pressure.
Eigen::VectorXd bulge_shape(const Problem& problem, const Assembly& assembly, double pressure_eV_per_A3);

/// Conjugate depth (Å) of the right size for a force: the stiffest of stretching, pretension and bending
/// alone.
double start_depth(const Problem& problem, double force_eV_per_A);

}  // namespace membrane::meridian
