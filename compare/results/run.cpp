#include "compare/results/run.hpp"

#include <cmath>

namespace validate {

void settle_part(Run& run) {
  const bool atoms = run.model == Model::atomistic;
  if (atoms == run.is_atomistic()) return;
  if (atoms)
    run.part.emplace<AtomsPart>();
  else
    run.part.emplace<ContinuumPart>();
}

std::vector<Run> prototypes(const Run&) {
  std::vector<Run> all(2);
  all[1].model = Model::atomistic;
  settle_part(all[1]);
  return all;
}

const std::vector<double>& load_values(const Run& run) {
  return run.load == LoadKind::pressure ? run.pressure_eV_per_A3 : run.force_eV_per_A;
}

std::vector<std::size_t> usable_points(const Run& run) {
  std::vector<std::size_t> usable;
  for (std::size_t i = 0; i < run.depth_A.size(); ++i) {
    const bool finite = std::isfinite(run.depth_A[i]) && std::isfinite(run.force_eV_per_A[i]);
    const bool artefact = run.is_atomistic() && run.atoms().artefact[i];
    if (finite && run.depth_A[i] > 0 && run.converged[i] && !artefact) usable.push_back(i);
  }
  return usable;
}

std::optional<std::size_t> first_artefact(const Run& run) {
  if (!run.is_atomistic()) return std::nullopt;
  const std::vector<bool>& artefact = run.atoms().artefact;
  const auto found = std::ranges::find(artefact, true);
  if (found == artefact.end()) return std::nullopt;
  return static_cast<std::size_t>(found - artefact.begin());
}

}  // namespace validate
