#include "compare/process/heated_curves.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "atomistic/protocol/heat_file.hpp"
#include "atomistic/protocol/step_file.hpp"

namespace validate {
namespace {

namespace fs = std::filesystem;

struct HeatListener {
  const AtomsPath& path;
  const fs::path& steps;
  double temperature_K;
  Progress& progress;

  void operator()(const atomistic::HeatEvent& e) const {
    const auto level = atomistic::read_heated_level(e.level, steps);
    if (!level) return;
    const std::string what =
        level->stable ? fmt::format("depth {:+.4f} Å, force {:+.2f} %", level->depth_shift_A,
                                    100 * level->force_shift_eV_per_A / level->force_eV_per_A)
                      : fmt::format("not stable: eigenvalue {:.2g} eV/Å²", level->lowest_eigenvalue_eV_per_A2);
    progress.say(fmt::format("atoms {:5} {:2}/{}  at {:g} K: {}  ({} force calls, {:.1f} s)", path.name, e.level + 1,
                             path.problem.levels.size(), temperature_K, what, level->force_calls, level->seconds));
  }
  template <class Other>
  void operator()(const Other&) const {}
};

}  // namespace

std::vector<HeatedCurve> heat_curves(const AtomsLaunch& launch, const std::vector<AtomsPath>& paths,
                                     const atomistic::Heat& heat, int ranks, const fs::path& work, Progress& progress) {
  std::vector<AtomsJob> jobs;
  std::vector<fs::path> steps;
  for (const AtomsPath& path : paths) {
    const std::string name = path.name + "-heat";
    steps.push_back(work / path.name / "steps");
    jobs.push_back(
        {name,
         {atomistic::HeatJob{path.problem, heat, steps.back().string()}, (work / name / "log.lammps").string()},
         ranks});
  }
  const auto outcomes = run_jobs(launch, jobs, work, [&](std::size_t i, const atomistic::Event& event) {
    std::visit(HeatListener{paths[i], steps[i], heat.temperature_K, progress}, event);
  });
  std::vector<HeatedCurve> curves(paths.size());
  for (std::size_t i = 0; i < paths.size(); ++i) {
    for (const atomistic::Step& step : atomistic::read_equilibria(steps[i]))
      if (auto level = atomistic::read_heated_level(step.level, steps[i]))
        curves[i].levels.push_back(std::move(*level));
    if (outcomes[i].finished) continue;
    curves[i].failure =
        fmt::format("atoms, {} load, at {:g} K: {}", paths[i].name, heat.temperature_K, outcomes[i].failure);
    if (outcomes[i].fault == atomistic::Fault::file) curves[i].failure_code = ExitCode::file_failed;
  }
  return curves;
}

}  // namespace validate
