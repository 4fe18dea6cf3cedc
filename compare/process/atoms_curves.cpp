#include "compare/process/atoms_curves.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "atomistic/protocol/step_file.hpp"
#include "compare/base/paths.hpp"
#include "compare/process/provenance.hpp"

namespace validate {
namespace {

namespace fs = std::filesystem;

/// Below this size a second MPI rank does not pay for its communication.
constexpr int fewest_atoms_per_rank = 3000;

fs::path steps_folder(const fs::path& work, const AtomsPath& path) { return work / path.name / "steps"; }

/// One that the program has just written.
atomistic::Step told_step(const fs::path& file) {
  try {
    return atomistic::read_step(file);
  } catch (const std::runtime_error& error) {
    throw Error(ExitCode::file_failed, error.what());
  }
}

/// Levels done so far in each path, a level in progress counting half.
class Ahead {
 public:
  explicit Ahead(const std::vector<AtomsPath>& paths) : paths_(paths), done_(paths.size(), 0.0) {}

  double fraction(std::size_t index, int level) {
    const atomistic::Problem& p = paths_[index].problem;
    const double steps = static_cast<double>(p.levels.size()) * (p.unload ? 2 : 1) - (p.unload ? 1 : 0);
    done_[index] = (level + 0.5) / steps;
    double sum = 0;
    for (const double done : done_) sum += done;
    return sum / static_cast<double>(done_.size());
  }

 private:
  const std::vector<AtomsPath>& paths_;
  std::vector<double> done_;
};

struct Listener {
  std::size_t index;
  const AtomsPath& path;
  const fs::path& work;
  AtomsCurve& curve;
  Ahead& ahead;
  Progress& progress;

  void operator()(const atomistic::StartEvent& e) const { curve.lammps = lammps_release(e.lammps_version); }
  void operator()(const atomistic::EndEvent& e) const { curve.report = e.report; }
  void operator()(const atomistic::ProgressEvent& e) const {
    const double fraction = ahead.fraction(index, e.level);
    const double left = progress.elapsed_s() * (1 - fraction) / std::max(fraction, 1e-3);
    progress.status(fmt::format("{} about {:.0f} s left; {}: level {}/{}, {} evaluations, max|f| {:.1e} eV/Å",
                                bar(fraction), left, path.name, e.level + 1, path.problem.levels.size(), e.evaluations,
                                e.max_force_eV_per_A));
  }
  void operator()(const atomistic::StepEvent& e) const {
    const atomistic::Step step = told_step(steps_folder(work, path) / e.file);
    constexpr double near_artefact_A = 0.02;
    const bool near = step.longest_bond_A >= path.problem.potential.artefact_bond_A - near_artefact_A;
    const std::string place = step.search ? "break" : fmt::format("{:2}/{}", e.level + 1, path.problem.levels.size());
    progress.say(
        fmt::format("atoms {:5} {}  depth {:7.3f} Å  force {:10.5f} eV/Å  {:3} evaluations  longest bond {:.3f} Å{}{}",
                    path.name, place, step.depth_A, step.force_eV_per_A, step.evaluations, step.longest_bond_A,
                    near && !step.broken ? "  (near the artefact zone)" : "",
                    step.broken      ? "  broken"
                    : step.converged ? ""
                                     : "  not converged"));
  }
  template <class Other>
  void operator()(const Other&) const {}
};

/// A sheet's vectors at every level of every curve are a good part of the program's memory, and only the last are asked
/// for.
void keep_last_state(std::vector<atomistic::Step>& steps, bool keep_positions) {
  for (std::size_t k = 0; k + 1 < steps.size(); ++k) {
    for (Eigen::VectorXd* state : {&steps[k].forces, &steps[k].factorised_at, &steps[k].virials}) state->resize(0);
    if (!keep_positions) steps[k].positions.resize(0);
  }
}

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
  Ahead ahead(paths);
  const auto outcomes = run_jobs(launch, jobs, work, [&](std::size_t i, const atomistic::Event& event) {
    std::visit(Listener{i, paths[i], work, curves[i], ahead, progress}, event);
  });
  for (std::size_t i = 0; i < paths.size(); ++i) {
    curves[i].steps = atomistic::read_finished_steps(steps_folder(work, paths[i]));
    keep_last_state(curves[i].steps, paths[i].keep_positions);
    const int next = static_cast<int>(curves[i].steps.size());
    const fs::path damaged = steps_folder(work, paths[i]) / atomistic::step_file_name(next);
    if (outcomes[i].finished && !is_there(damaged)) continue;
    if (outcomes[i].finished) {
      curves[i].failure = fmt::format("'{}' has been damaged; --resume computes it again", damaged.string());
      curves[i].failure_code = ExitCode::file_failed;
      continue;
    }
    curves[i].failure = fmt::format("atoms, {} load: {}", paths[i].name, outcomes[i].failure);
    if (outcomes[i].fault == atomistic::Fault::file) curves[i].failure_code = ExitCode::file_failed;
  }
  return curves;
}

}  // namespace validate
