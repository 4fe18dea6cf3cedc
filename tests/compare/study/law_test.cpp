// The law that a case names is the one that is solved.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "compare/study/study.hpp"
#include "membrane/problem.hpp"

using namespace validate;

namespace {

constexpr double Eh = 20, nu = 0.2, radius_A = 100, tip_A = 10;
const std::vector<double> levels_A = {10, 20};

Case of_law(const std::string& name, const std::map<std::string_view, double>& parameters = {}) {
  Case c;
  c.potential.clear();
  c.models = Models::membrane;
  c.radius_A = radius_A;
  c.tip_radius_A = tip_A;
  c.loads = {LoadKind::disc};
  c.depth_max_A = levels_A.back();
  c.depth_step_A = levels_A.front();
  c.E_eV_per_A3 = Eh / 2;
  c.thickness_A = 2;
  c.nu = nu;
  c.cells = 12;
  c.law.name = name;
  for (std::size_t i = 0; i < law_keys().size(); ++i)
    if (const auto at = parameters.find(law_keys()[i].name); at != parameters.end()) c.law.parameters[i] = at->second;
  return c;
}

Run solved(const Case& c, Command command = Command::indentation) {
  Progress quiet(true);
  const StudyOutcome outcome = run_study(command, c, std::nullopt, {}, quiet);
  EXPECT_EQ(outcome.result.runs.size(), 1u);
  return outcome.result.runs.at(0);
}

TEST(CaseLaw, GivesTheCurveOfTheMembranesOwnProblem) {
  const auto run = solved(of_law("lee", {{"third-order", -40}}));
  membrane::Problem problem;
  problem.sheet = membrane::DiscSheet{.radius_A = radius_A, .rings = 12};
  problem.law = membrane::LeeGraphene{Eh, nu, -40};
  problem.load = membrane::DiscLoad{tip_A};
  problem.levels = run.conjugate_depth_A;
  std::vector<double> force;
  membrane::solve(problem, [&](const membrane::Step& step) {
    force.push_back(step.force_eV_per_A);
    return true;
  });
  EXPECT_EQ(run.law, "lee");
  ASSERT_EQ(run.force_eV_per_A.size(), levels_A.size());
  ASSERT_EQ(force.size(), levels_A.size());
  for (std::size_t i = 0; i < force.size(); ++i) EXPECT_NEAR(run.force_eV_per_A[i] / force[i], 1, 1e-7);
  EXPECT_LT(run.force_eV_per_A.back(), 0.97 * solved(of_law("svk")).force_eV_per_A.back());  // it softens
}

/// A law that joins the list must be one that an experiment can solve, under an indenter and under a pressure.
TEST(CaseLaw, EveryLawOfTheListCanBeChosen) {
  std::map<double, std::string> forces;
  for (const membrane::LawEntry& entry : membrane::laws_by_name()) {
    SCOPED_TRACE(entry.name);
    std::map<std::string_view, double> parameters;
    for (const Field& key : law_keys())
      for (const membrane::LawParameter& p : entry.parameters)
        if (std::string name(p.name); !p.usual && (std::ranges::replace(name, '_', '-'), name == key.name))
          parameters[key.name] = 0.3;
    Case c = of_law(std::string(entry.name), parameters);
    EXPECT_NO_THROW(check(c));
    const auto indented = solved(c);
    EXPECT_EQ(indented.law, entry.name);
    EXPECT_EQ(indented.ended, Ended::depth_max);
    ASSERT_EQ(indented.force_eV_per_A.size(), levels_A.size());
    EXPECT_TRUE(forces.emplace(indented.force_eV_per_A.back(), entry.name).second);

    c.loads = {LoadKind::pressure};
    c.pressures_eV_per_A3 = {5e-3};
    const auto pressed = solved(c, Command::bulge);
    EXPECT_EQ(pressed.law, entry.name);
    EXPECT_EQ(pressed.ended, Ended::depth_max);
    EXPECT_GT(pressed.depth_A.at(0), 5);
  }
  EXPECT_EQ(forces.size(), law_names().size());
}

}  // namespace
