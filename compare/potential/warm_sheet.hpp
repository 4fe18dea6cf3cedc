// The flat sheet of a potential at a temperature, computed by validate-atoms.
#pragma once

#include <vector>

#include "atomistic/temperature.hpp"
#include "compare/potential/potential_card.hpp"

namespace validate {

struct WarmPotential {
  atomistic::WarmCard card;
  std::vector<atomistic::StrainState> strains;
  std::vector<double> free_energy_eV_per_A2;  ///< of the vibrations under each strain, less the unstrained sheet's
};

/// Throws Error: atomistic failed, bad input for a sheet that has no lattice constant there.
WarmPotential warm_potential(const PotentialCard& card, const atomistic::Heat& heat,
                             const std::vector<atomistic::StrainState>& strains, const AtomsLaunch& launch);

}  // namespace validate
