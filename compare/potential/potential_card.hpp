// All that `validate potential` tells of a potential: computed by validate-atoms, kept by hash.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "atomistic/problem.hpp"
#include "atomistic/response.hpp"
#include "compare/input/potential_file.hpp"
#include "compare/potential/law/calibrated_law.hpp"
#include "compare/process/atoms.hpp"

namespace validate {

struct PotentialCard {
  PotentialFile potential;
  atomistic::Card card;
  atomistic::Response response;
  std::string lammps;  ///< release that computed it
  bool from_cache = false;
  std::optional<CalibratedLaw> law;  ///< made from the response's states
  std::string no_law;                ///< why there is none
};

/// What the numbers depend on, as one SHA-256: the potential's description and parameters, this program's version.
std::string card_key(const PotentialFile& potential);

/// $XDG_CACHE_HOME/validate/cards, else ~/.cache/validate/cards; empty, no cache, without either.
std::filesystem::path card_cache();

/// From the cache unless `refresh`; computed otherwise, in a temporary folder that stays where the atomistic program
/// fails. A cache that cannot be read or written is no error. Throws Error: bad input for a pair style that LAMMPS
/// lacks; atomistic failed.
PotentialCard potential_card(const PotentialFile& potential, const AtomsLaunch& launch,
                             const std::filesystem::path& cache, bool refresh);

}  // namespace validate
