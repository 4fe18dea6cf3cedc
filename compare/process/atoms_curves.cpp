#include "compare/process/atoms_curves.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "atomistic/protocol/step_file.hpp"
#include "compare/process/provenance.hpp"

namespace validate {
namespace {

namespace fs = std::filesystem;

/// Below this size a second MPI rank does not pay for its communication.
constexpr int fewest_atoms_per_rank = 3000;

fs::path steps_folder(const fs::path& work, const AtomsPath& path) { return work / path.name / "steps"; }

struct Listener {
  const AtomsPath& path;
  const fs::path& work;
  AtomsCurve& curve;
  Progress& progress;

  void operator()(const atomistic::StartEvent& e) const { curve.lammps = lammps_release(e.lammps_version); }
  void operator()(const atomistic::EndEvent& e) const { curve.report = e.report; }
  void operator()(const atomistic::ProgressEvent& e) const {
    progress.status(fmt::format("{}: level {}/{}, {} evaluations, max|f| {:.1e} eV/Å", path.name, e.level + 1,
                                path.problem.levels.size(), e.evaluations, e.max_force_eV_per_A));
  }
  void operator()(const atomistic::StepEvent& e) const {
    const atomistic::Step step = atomistic::read_step(steps_folder(work, path) / e.file);
    progress.say(fmt::format("atoms {}  {}/{}  level {:.5g}  depth {:.3f} Å  {} evaluations  longest bond {:.3f} Å{}",
                             path.name, e.level + 1, path.problem.levels.size(), step.target, step.depth_A,
                             step.evaluations, step.longest_bond_A, step.converged ? "" : "  not converged"));
  }
  template <class Other>
  void operator()(const Other&) const {}
};

}  // namespace

int useful_ranks(const AtomsLaunch& launch, int atoms, int side_by_side) {
  if (!launch.launcher.empty() || !has_mpiexec()) return 1;
  return std::clamp(atoms / fewest_atoms_per_rank, 1, std::max(1, launch.cores / std::min(launch.cores, side_by_side)));
}

std::vector<AtomsCurve> compute_curves(const AtomsLaunch& launch, const std::vector<AtomsPath>& paths, int ranks,
                                       const fs::path& work, Progress& progress) {
  std::vector<AtomsJob> jobs;
  for (const AtomsPath& path : paths) {
    fs::create_directories(steps_folder(work, path));
    jobs.push_back({path.name,
                    {atomistic::CurveJob{path.problem, steps_folder(work, path).string()},
                     (work / path.name / "log.lammps").string()},
                    ranks});
  }
  std::vector<AtomsCurve> curves(paths.size());
  const auto outcomes = run_jobs(launch, jobs, work, [&](std::size_t i, const atomistic::Event& event) {
    std::visit(Listener{paths[i], work, curves[i], progress}, event);
  });
  for (std::size_t i = 0; i < paths.size(); ++i) {
    curves[i].steps = atomistic::read_finished_steps(steps_folder(work, paths[i]));
    if (outcomes[i].finished) continue;
    curves[i].failure = fmt::format("atoms, {}: {}", paths[i].name, outcomes[i].failure);
    if (outcomes[i].fault == atomistic::Fault::file) curves[i].failure_code = ExitCode::file_failed;
  }
  return curves;
}

}  // namespace validate
