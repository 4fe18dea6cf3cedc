#include "compare/process/sampled_levels.hpp"

#include <fmt/format.h>

#include "atomistic/protocol/heat_file.hpp"
#include "atomistic/protocol/step_file.hpp"

namespace validate {
namespace {

namespace fs = std::filesystem;

struct SampleListener {
  const std::string& name;
  double length_ps;
  Progress& progress;

  void operator()(const atomistic::SampleEvent& e) const {
    progress.status(fmt::format("{} dynamics of {}: level {}, {:.0f} of {:.0f} ps, depth {:.4f} ± {:.4f} Å",
                                bar(e.length_ps / length_ps), name, e.level + 1, e.length_ps, length_ps, e.mean_depth_A,
                                e.error_A));
  }
  template <class Other>
  void operator()(const Other&) const {}
};

/// A level to sample: of which path.
struct ToSample {
  std::size_t path;
  int level;
};

void say(const AtomsPath& path, const atomistic::Sampled& s, Progress& progress) {
  progress.say(
      fmt::format("atoms {:5} {:2}/{}  dynamics: depth {:.4f} ± {:.4f} Å in {:.0f} ps ({:.0f} samples, {:.2f} ps "
                  "of warm-up)",
                  path.name, s.level + 1, path.problem.levels.size(), s.mean_depth_A, s.error_A, s.length_ps, s.samples,
                  s.warm_up_ps));
}

}  // namespace

std::vector<SampledCurve> sample_levels(const AtomsLaunch& launch, const std::vector<AtomsPath>& paths,
                                        const atomistic::Sampling& sampling, const fs::path& work, Progress& progress) {
  std::vector<AtomsJob> jobs;
  std::vector<ToSample> asked;
  const auto steps = [&](std::size_t i) { return work / paths[i].name / "steps"; };
  for (std::size_t i = 0; i < paths.size(); ++i)
    for (const atomistic::Step& step : atomistic::read_equilibria(steps(i))) {
      const std::string name = fmt::format("{}-sample-{}", paths[i].name, step.level);
      asked.push_back({i, step.level});
      jobs.push_back({name,
                      {atomistic::SampleJob{paths[i].problem, sampling, step.level, steps(i).string()},
                       (work / name / "log.lammps").string()},
                      1});
    }
  const auto outcomes = run_jobs(launch, jobs, work, [&](std::size_t k, const atomistic::Event& event) {
    std::visit(SampleListener{paths[asked[k].path].name, sampling.length_ps, progress}, event);
  });
  std::vector<SampledCurve> curves(paths.size());
  for (std::size_t k = 0; k < asked.size(); ++k) {
    const std::size_t i = asked[k].path;
    SampledCurve& curve = curves[i];
    if (auto sampled = atomistic::read_sampled(asked[k].level, steps(i))) {
      say(paths[i], *sampled, progress);
      curve.levels.push_back(std::move(*sampled));
    }
    if (outcomes[k].finished || !curve.failure.empty()) continue;
    curve.failure =
        fmt::format("atoms, {} load, dynamics of level {}: {}", paths[i].name, asked[k].level + 1, outcomes[k].failure);
    if (outcomes[k].fault == atomistic::Fault::file) curve.failure_code = ExitCode::file_failed;
  }
  return curves;
}

}  // namespace validate
