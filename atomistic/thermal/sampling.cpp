#include "atomistic/thermal/sampling.hpp"

#include <cmath>
#include <stdexcept>

#include "atomistic/equilibrium/indentation.hpp"
#include "atomistic/loads/load_term.hpp"
#include "atomistic/thermal/series.hpp"

namespace atomistic {
namespace {

constexpr int steps_per_stretch = 1000, steps_per_sample = 10;
constexpr double step_ps = 1e-3;
constexpr double least_ps = 5;  // before an error is believed

Eigen::VectorXd vector_from(const std::vector<double>& numbers) {
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

std::vector<double> numbers_from(const Eigen::VectorXd& v) { return {v.data(), v.data() + v.size()}; }

bool known_well(const Sampled& s, const Sampling& sampling) {
  return s.length_ps >= least_ps && s.error_A <= sampling.relative_error * s.mean_depth_A;
}

}  // namespace

void evaluate(Sampled& s) {
  const SeriesMean mean = mean_of(s.depths_A);
  constexpr double sample_ps = steps_per_sample * step_ps;
  s.mean_depth_A = mean.mean;
  s.error_A = mean.error;
  s.samples = mean.samples;
  s.warm_up_ps = static_cast<double>(mean.warm_up) * sample_ps;
  s.correlation_ps = mean.correlation_length * sample_ps;
  s.length_ps = static_cast<double>(s.depths_A.size()) * sample_ps;
}

Sampled sample_level(const Problem& problem, const Step& step, const Sampling& sampling, const std::string& log_file,
                     const std::optional<Sampled>& kept, const std::function<void(const Sampled&)>& keep) {
  if (!std::holds_alternative<PointLoad>(problem.load) && !std::holds_alternative<DiscLoad>(problem.load))
    throw std::invalid_argument("dynamics: a dead force is held, of a point or a disc load");
  const Sheet sheet = make_sheet(problem);
  ForceField forces(problem.potential, box_around(sheet), sheet.positions, log_file);
  const LangevinBath bath{.temperature_K = sampling.temperature_K,
                          .step_ps = step_ps,
                          .free_atoms = sheet.free_atoms,
                          .loaded = loaded_atoms(problem.load, sheet),
                          .force_eV_per_A = step.force_eV_per_A};
  Sampled s = kept.value_or(Sampled{});
  s.level = step.level;
  PhasePoint at{step.positions, {}};
  if (kept) at = {vector_from(kept->positions_A), vector_from(kept->velocities_A_per_ps)};
  while (s.length_ps < sampling.length_ps && !known_well(s, sampling)) {
    const unsigned seed =
        sampling.seed + 1000003u * static_cast<unsigned>(step.level + 1) + 7919u * static_cast<unsigned>(++s.stretches);
    for (const double depth : forces.langevin(bath, at, steps_per_stretch, steps_per_sample, seed % 900000000u + 1))
      s.depths_A.push_back(depth);
    if (!at.positions.allFinite()) throw std::runtime_error("the sheet came apart in the dynamics");
    s.positions_A = numbers_from(at.positions);
    s.velocities_A_per_ps = numbers_from(at.velocities);
    evaluate(s);
    keep(s);
  }
  return s;
}

}  // namespace atomistic
