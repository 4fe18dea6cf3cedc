#include "compare/potential/warm_sheet.hpp"

#include <fmt/format.h>

#include "compare/base/errors.hpp"
#include "compare/base/temporary_folder.hpp"

namespace validate {

WarmPotential warm_potential(const PotentialCard& card, const atomistic::Heat& heat,
                             const std::vector<atomistic::StrainState>& strains, const AtomsLaunch& launch) {
  TemporaryFolder folder("validate-warm");
  const AtomsJob job{"warm",
                     {atomistic::WarmJob{card.potential.potential, card.card, heat, strains},
                      (folder.path() / "warm" / "log.lammps").string()},
                     1};
  WarmPotential warm{.card = {}, .strains = strains, .free_energy_eV_per_A2 = {}};
  const auto outcomes = run_jobs(launch, {job}, folder.path(), [&](std::size_t, const atomistic::Event& event) {
    if (const auto* e = std::get_if<atomistic::WarmEvent>(&event))
      warm.card = e->card, warm.free_energy_eV_per_A2 = e->free_energy_eV_per_A2;
  });
  if (outcomes[0].finished) return warm;
  folder.keep();
  throw Error(ExitCode::atomistic_failed,
              fmt::format("the flat sheet at {:g} K: {}", heat.temperature_K, outcomes[0].failure));
}

}  // namespace validate
