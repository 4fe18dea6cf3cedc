#include "tests/benchmark/atomistic/support.hpp"

#include <chrono>
#include <map>
#include <sstream>
#include <stdexcept>

#include "atomistic/cell/card.hpp"
#include "atomistic/cell/response.hpp"
#include "atomistic/protocol/math_threads.hpp"
#include "compare/input/potential_file.hpp"
#include "compare/pairing/guides.hpp"
#include "compare/pairing/pairing.hpp"
#include "compare/potential/law/calibrated_law.hpp"
#include "compare/potential/law/states.hpp"

namespace benchmark_support {

using namespace atomistic;

namespace {

const std::string folder = VALIDATE_SOURCE_INPUTS "/potentials";

Load load_of(const std::string& name, double radius_A) {
  const std::map<std::string, Load> loads = {
      {"point", PointLoad{}}, {"disc", DiscLoad{radius_A / 11}}, {"sphere", SphereLoad{.radius_A = radius_A / 4}}};
  return loads.at(name);
}

const validate::CalibratedLaw& law(const std::string& name) {
  static std::map<std::string, validate::CalibratedLaw> laws;
  if (!laws.contains(name)) {
    const Card& c = card(name);
    const validate::CalibrationRange range = validate::calibration_range(potential(name).artefact_bond_A);
    laws[name] = validate::calibrate(
        c, compute_response(potential(name), c, validate::calibration_strains(c.bond_A(), range), "none").states,
        range);
  }
  return laws[name];
}

/// The shapes that the comparison hands over, too.
std::vector<Guide> guides(const Problem& problem, const std::string& name, const std::string& load) {
  validate::Case c;
  c.radius_A = problem.radius_A;
  c.tip_radius_A = load == "sphere" ? problem.radius_A / 4 : problem.radius_A / 11;
  c.loads = {validate::from_word<validate::LoadKind>(load).value()};
  validate::PotentialFile file;
  file.potential = problem.potential;
  validate::PotentialCard card;
  card.card = problem.card;
  card.law = law(name);
  const validate::PairedSheet sheet(c, problem.potential, problem.card);
  validate::ContinuumExperiment guide = validate::pair(c, {file, card, sheet}).front().guide.value();
  guide.problem.levels = problem.levels;
  return validate::guides_from(guide.problem);
}

}  // namespace

std::vector<std::string> split(const std::string& comma_separated) {
  std::vector<std::string> parts;
  std::istringstream in(comma_separated);
  for (std::string part; std::getline(in, part, ',');) parts.push_back(part);
  return parts;
}

std::vector<std::string> shipped_potentials() { return validate::available_potentials(folder); }

Potential potential(const std::string& name) { return validate::read_potential(name, folder, "benchmark").potential; }

const Card& card(const std::string& name) {
  static std::map<std::string, Card> cards;
  if (!cards.contains(name)) cards[name] = compute_card(potential(name), "none");
  return cards[name];
}

std::string name_of(Ended ended) {
  switch (ended) {
    case Ended::depth_max:
      return "depth_max";
    case Ended::artefact:
      return "artefact";
    case Ended::rupture:
      return "rupture";
    case Ended::not_converged:
      return "not_converged";
  }
  return "";
}

Problem disc_problem(const std::string& potential_name, double radius_A, const std::string& load) {
  Problem problem;
  problem.potential = potential(potential_name);
  problem.card = card(potential_name);
  problem.radius_A = radius_A;
  problem.load = load_of(load, radius_A);
  for (int k = 1; k <= 11; ++k) problem.levels.push_back(k * radius_A / 55);
  problem.guides = guides(problem, potential_name, load);
  return problem;
}

Path follow(const Problem& problem, const MpiSession& session) {
  use_one_math_thread();
  const auto start = std::chrono::steady_clock::now();
  Path path;
  path.atoms = make_sheet(problem).atoms();
  const PathCallbacks callbacks{
      .on_step =
          [&](const Step& step) {
            path.steps.push_back(step);
            for (Eigen::VectorXd* v :
                 {&path.steps.back().positions, &path.steps.back().forces, &path.steps.back().factorised_at})
              v->resize(0);
          },
      .on_progress = {}};
  path.report = follow_path(problem, "none", {}, callbacks, session);
  path.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return path;
}

}  // namespace benchmark_support
