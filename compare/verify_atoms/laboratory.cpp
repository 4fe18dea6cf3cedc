#include "compare/verify_atoms/laboratory.hpp"

#include <utility>

#include "atomistic/protocol/event.hpp"
#include "atomistic/protocol/job.hpp"
#include "compare/base/errors.hpp"
#include "compare/input/potential_file.hpp"
#include "compare/process/atoms_curves.hpp"

namespace validate::verify {

const PotentialCard& Laboratory::card(const std::string& potential) {
  const auto found = cards_.find(potential);
  if (found != cards_.end()) return found->second;
  const PotentialFile file = read_potential(potential, means_.potentials, "--potential");
  return cards_.emplace(potential, potential_card(file, means_.launch, means_.cards, false)).first->second;
}

/// The answer of a job that has one.
atomistic::Event Laboratory::last_event(const std::string& name, decltype(atomistic::Job::work) work) {
  atomistic::Event answer;
  const AtomsJob job{name, {std::move(work), (folder_.path() / name / "log.lammps").string()}, 1};
  const auto outcomes = run_jobs(means_.launch, {job}, folder_.path(), [&](std::size_t, const atomistic::Event& event) {
    if (std::holds_alternative<atomistic::ForcesEvent>(event) ||
        std::holds_alternative<atomistic::ResponseEvent>(event))
      answer = event;
  });
  if (!outcomes[0].finished) throw Error(ExitCode::atomistic_failed, outcomes[0].failure);
  return answer;
}

std::vector<atomistic::AtomForces> Laboratory::forces(const std::string& potential,
                                                      std::vector<Eigen::VectorXd> positions) {
  const atomistic::ForcesJob job{card(potential).potential.potential, std::move(positions)};
  return std::get<atomistic::ForcesEvent>(last_event(next_name(), job)).states;
}

std::vector<atomistic::HomogeneousState> Laboratory::states(const std::string& potential,
                                                            std::vector<atomistic::StrainState> strains) {
  const PotentialCard& of = card(potential);
  const atomistic::ResponseJob job{of.potential.potential, of.card, std::move(strains)};
  return std::get<atomistic::ResponseEvent>(last_event(next_name(), job)).response.states;
}

std::vector<atomistic::Step> Laboratory::path(const atomistic::Problem& problem, int ranks) {
  const auto curves = compute_curves(means_.launch, {{next_name(), problem}}, ranks, folder_.path(), quiet_);
  if (!curves[0].failure.empty()) throw Error(curves[0].failure_code, curves[0].failure);
  return curves[0].steps;
}

atomistic::Problem Laboratory::problem(const std::string& potential, double radius_A, const atomistic::Load& load,
                                       std::vector<double> levels) {
  atomistic::Problem problem;
  problem.potential = card(potential).potential.potential;
  problem.card = card(potential).card;
  problem.radius_A = radius_A;
  problem.load = load;
  problem.levels = std::move(levels);
  return problem;
}

}  // namespace validate::verify
