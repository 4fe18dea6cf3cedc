// What a curve of atoms will take, before anything is started: memory and time by stage.
#pragma once

#include <string>

#include "atomistic/problem.hpp"
#include "compare/input/case.hpp"
#include "compare/process/atoms.hpp"

namespace validate {

/// Of one curve. Times are those of one core.
struct AtomsBudget {
  double atoms = 0;  ///< clamped ones included
  atomistic::Preconditioning preconditioning = atomistic::Preconditioning::factor;
  double memory_bytes = 0;  ///< over all its ranks
  double start_s = 0, forces_s = 0, set_ups_s = 0, solves_s = 0;

  double all_s() const { return start_s + forces_s + set_ups_s + solves_s; }
};

/// From the radius and graphene's lattice constant, for so many levels. The figures behind it were measured, on sheets
/// of 15 000 to 1.2 million atoms.
AtomsBudget atoms_budget(const Case& c, const atomistic::Potential& potential, std::size_t levels);

/// How many of the case's curves fit into the memory at once; at least 1. All, where the memory is not known or the
/// ranks are a launcher's, on machines of their own.
int curves_at_once(const AtomsBudget& budget, const AtomsLaunch& launch, int curves);

/// Throws Error (bad input) where not even one curve fits, with what it needs, what there is, and the ways out.
void require_memory(const Case& c, const atomistic::Potential& potential, const AtomsLaunch& launch);

}  // namespace validate
