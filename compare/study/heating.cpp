#include "compare/study/heating.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "compare/fitting/run_fit.hpp"
#include "compare/process/heated_curves.hpp"
#include "compare/process/sampled_levels.hpp"
#include "compare/study/breaking.hpp"

namespace validate {
namespace {

using atomistic::HeatedLevel;

/// One load's path as it is heated: the run's own, or the one whose rim is at the temperature's lattice constant.
struct HeatedPath {
  const HeatedCurve& heated;
  const SampledCurve* sampled = nullptr;
};

template <class Level>
const Level* level_of(const std::vector<Level>& levels, int level) {
  const auto found = std::ranges::find(levels, level, &Level::level);
  return found == levels.end() ? nullptr : &*found;
}

/// A depth d' at the force F' of the heated path, carried to the force of the run's level along the path's own slope,
/// as a power of the force.
double carried_to_force(const HeatedLevel& warm, double depth, double force) {
  const double power = warm.compliance_A2_per_eV * warm.force_eV_per_A / warm.conjugate_depth_A;
  return depth * std::pow(force / warm.force_eV_per_A, power);
}

/// The same of a force, carried to the depth of the run's level.
double carried_to_depth(const HeatedLevel& warm, double force, double depth) {
  const double power = warm.conjugate_depth_A / (warm.compliance_A2_per_eV * warm.force_eV_per_A);
  return force * std::pow(depth / warm.conjugate_depth_A, power);
}

void append(Thermal& thermal, const HeatedLevel* warm, double depth, double force) {
  const bool known = warm && warm->stable;
  thermal.stable.push_back(known);
  thermal.lowest_eigenvalue_eV_per_A2.push_back(warm ? warm->lowest_eigenvalue_eV_per_A2 : not_known);
  if (!known) {
    thermal.depth_shift_A.push_back(not_known);
    thermal.force_ratio.push_back(not_known);
    return;
  }
  const double at_force = carried_to_force(*warm, warm->conjugate_depth_A + warm->depth_shift_A, force);
  const double at_depth = carried_to_depth(*warm, warm->force_eV_per_A + warm->force_shift_eV_per_A, depth);
  thermal.depth_shift_A.push_back(at_force - depth);
  thermal.force_ratio.push_back(at_depth / force);
}

void append(Dynamics& md, const atomistic::Sampled* sampled, const HeatedLevel* warm, double depth, double force) {
  const bool known = sampled && warm && std::isfinite(sampled->error_A) && warm->compliance_A2_per_eV > 0;
  md.mean_A.push_back(known ? carried_to_force(*warm, sampled->mean_depth_A, force) - depth : not_known);
  md.error_A.push_back(known ? sampled->error_A : not_known);
  md.samples.push_back(known ? sampled->samples : not_known);
  md.warm_up_ps.push_back(known ? sampled->warm_up_ps : not_known);
  md.correlation_ps.push_back(known ? sampled->correlation_ps : not_known);
  md.length_ps.push_back(sampled ? sampled->length_ps : 0);
}

/// The first level that is no equilibrium, and its softest vibration, in words.
std::string instability(const HeatedCurve& heated) {
  const auto found = std::ranges::find(heated.levels, false, &HeatedLevel::stable);
  if (found == heated.levels.end() || found->modes.empty()) return {};
  const atomistic::Mode& mode = found->modes.front();
  return fmt::format(
      "at a conjugate depth of {:.4g} Å the softest vibration has the eigenvalue {:.3g} eV/Å² ({:.3g} THz), {:.0f} % "
      "out of the plane, at {:.3g} Å from the axis",
      found->conjugate_depth_A, mode.eigenvalue_eV_per_A2, mode.frequency_THz, 100 * mode.out_of_plane, mode.radius_A);
}

/// What Eq. 16 reads from the depths that could be heated, at T = 0 and at the temperature.
void read_both(const Run& run, Thermal& thermal) {
  std::vector<double> depth, cold, warm;
  for (const std::size_t i : usable_points(run)) {
    if (!std::isfinite(thermal.force_ratio[i]) || !(thermal.force_ratio[i] > 0)) continue;
    depth.push_back(run.depth_A[i]);
    cold.push_back(run.force_eV_per_A[i]);
    warm.push_back(run.force_eV_per_A[i] * thermal.force_ratio[i]);
  }
  thermal.cold = read_by_eq16(run, depth, cold);
  thermal.warm = read_by_eq16(run, depth, warm);
}

Thermal thermal_of(const Case& c, const Run& run, const AtomsCurve& curve, const HeatedPath& path, double rim_strain) {
  Thermal thermal{.temperature_K = *c.temperature_K,
                  .statistics = c.statistics,
                  .rim = c.rim == Rim::thermal ? Rim::thermal : Rim::at_rest,
                  .rim_strain = rim_strain};
  if (path.sampled) thermal.md.emplace();
  for (const atomistic::Step* step : steps_of_curve(curve.steps)) {
    const HeatedLevel* warm = level_of(path.heated.levels, step->level);
    append(thermal, warm, step->conjugate_depth_A, step->force_eV_per_A);
    if (path.sampled)
      append(*thermal.md, level_of(path.sampled->levels, step->level), warm, step->conjugate_depth_A,
             step->force_eV_per_A);
  }
  thermal.unstable = instability(path.heated);
  thermal.hessian_error_relative = thermal.seconds_per_depth = 0;
  for (const HeatedLevel& level : path.heated.levels) {
    thermal.hessian_error_relative = std::max(thermal.hessian_error_relative, level.hessian_error_relative);
    thermal.seconds_per_depth += level.seconds / static_cast<double>(path.heated.levels.size());
  }
  read_both(run, thermal);
  return thermal;
}

/// The same paths with the whole sheet stretched.
std::vector<AtomsPath> stretched(std::vector<AtomsPath> paths, double strain) {
  for (AtomsPath& path : paths) {
    path.name += "-warm-rim";
    path.problem.biaxial_strain = (1 + path.problem.biaxial_strain) * (1 + strain) - 1;
  }
  return paths;
}

void note_failure(const std::string& failure, ExitCode code, StudyOutcome& outcome) {
  if (failure.empty() || !outcome.failure.empty()) return;
  outcome.failure = failure;
  outcome.failure_code = code;
}

}  // namespace

atomistic::Heat heat_of(const Case& c) {
  return {.temperature_K = c.temperature_K.value_or(0),
          .statistics =
              c.statistics == Statistics::quantum ? atomistic::Statistics::quantum : atomistic::Statistics::classical,
          .modes = static_cast<int>(c.modes)};
}

WarmSheet summary_of(const atomistic::WarmCard& warm, const atomistic::Card& card) {
  const double nu = warm.C12_eV_per_A2 / warm.C11_eV_per_A2;
  return {.temperature_K = warm.temperature_K,
          .statistics = warm.statistics == atomistic::Statistics::quantum ? Statistics::quantum : Statistics::classical,
          .lattice_constant_A = warm.lattice_constant_A,
          .stretch = warm.lattice_constant_A / card.a0_A - 1,
          .Eh_eV_per_A2 = warm.C11_eV_per_A2 * (1 - nu * nu),
          .nu = nu,
          .longest_wave_A = warm.longest_wave_A};
}

void heat_atoms(std::vector<PairedLoad>& loads, const std::vector<AtomsPath>& paths,
                const std::vector<AtomsCurve>& curves, int ranks, const StudyOptions& options, StudyOutcome& outcome,
                Progress& progress) {
  const Case& c = outcome.result.resolved;
  if (!c.temperature_K || !outcome.failure.empty()) return;
  const std::filesystem::path work = options.folder / "work";
  std::vector<AtomsPath> heated_paths = paths;
  double rim_strain = 0;
  if (c.rim == Rim::thermal && !outcome.result.warm.empty()) {
    rim_strain = outcome.result.warm.front().stretch;
    heated_paths = stretched(paths, rim_strain);
    for (const AtomsCurve& curve : compute_curves(options.launch, heated_paths, ranks, work, progress))
      note_failure(curve.failure, curve.failure_code, outcome);
  }
  const auto heated = heat_curves(options.launch, heated_paths, heat_of(c), ranks, work, progress);
  std::vector<SampledCurve> sampled;
  if (c.sample_ps)
    sampled = sample_levels(options.launch, heated_paths,
                            {.temperature_K = *c.temperature_K,
                             .length_ps = *c.sample_ps,
                             .relative_error = c.error,
                             .seed = static_cast<unsigned>(c.seed)},
                            work, progress);
  for (std::size_t i = 0; i < loads.size(); ++i) {
    Run& run = loads[i].atoms->run;
    const HeatedPath path{heated[i], sampled.empty() ? nullptr : &sampled[i]};
    run.thermal = thermal_of(c, run, curves[i], path, rim_strain);
    note_failure(heated[i].failure, heated[i].failure_code, outcome);
    if (path.sampled) note_failure(path.sampled->failure, path.sampled->failure_code, outcome);
  }
}

}  // namespace validate
