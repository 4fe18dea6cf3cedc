// A sheet that several ranks share: run by mpiexec with 2 and with 4 ranks. The factor's path, which rank 0 leads
// alone, is what it is held against. Every rank runs every test; what a step holds is rank 0's.
#include <gtest/gtest.h>

#include "atomistic/protocol/preconditioning.hpp"
#include "atomistic/ranks/halo.hpp"
#include "atomistic/ranks/mpi_team.hpp"
#include "tests/atomistic/support/paths.hpp"

namespace {

using namespace atomistic;
using Eigen::VectorXd;

struct SharedPath : testing::Test {
  void SetUp() override {
    ASSERT_GT(lammps_session().ranks(), 1) << "started without mpiexec";
    if (!has_multigrid()) GTEST_SKIP() << "built without hypre";
  }
};

bool leads() { return lammps_session().rank() == 0; }

Path path_with(Preconditioning kind, Problem problem, const std::vector<Step>& finished = {}) {
  problem.preconditioning = kind;
  problem.force_tolerance_eV_per_A = 1e-8;
  return follow(problem, finished);
}

void expect_the_same(const Step& one, const Step& other, double relative) {
  EXPECT_TRUE(one.converged);
  EXPECT_NEAR(one.force_eV_per_A, other.force_eV_per_A, relative * other.force_eV_per_A);
  EXPECT_NEAR(one.depth_A, other.depth_A, relative * other.depth_A);
  EXPECT_NEAR(one.conjugate_depth_A, other.conjugate_depth_A, relative * other.conjugate_depth_A);
  EXPECT_NEAR(one.energy_eV, other.energy_eV, 1e-8 + relative * other.energy_eV);
  EXPECT_NEAR(one.longest_bond_A, other.longest_bond_A, 1e-6);
  ASSERT_EQ(one.positions.size(), other.positions.size());
  ASSERT_EQ(one.forces.size(), other.forces.size());
  EXPECT_LT((one.positions - other.positions).cwiseAbs().maxCoeff(), 1e-4);
  EXPECT_LT((one.forces - other.forces).cwiseAbs().maxCoeff(), 1e-5);
}

TEST_F(SharedPath, HasTheForcesOfTheFactorsUnderEveryLoad) {
  const std::vector<std::pair<Load, Control>> loads = {{DiscLoad{6}, Control::conjugate_depth},
                                                       {PointLoad{}, Control::conjugate_depth},
                                                       {SphereLoad{.radius_A = 8}, Control::conjugate_depth},
                                                       {SphereLoad{.radius_A = 8}, Control::force},
                                                       {DiscLoad{6}, Control::force}};
  for (const auto& [load, control] : loads) {
    Problem problem = problem_of("tersoff", 30, load, {1, 2, 3});
    problem.control = control;
    const Path factor = path_with(Preconditioning::factor, problem);
    const Path shared = path_with(Preconditioning::multigrid, problem);
    if (!leads()) continue;
    SCOPED_TRACE(testing::Message() << "load " << load.index() << ", control " << static_cast<int>(control));
    ASSERT_EQ(factor.steps.size(), 3u);
    ASSERT_EQ(shared.steps.size(), 3u) << shared.report.reason;
    EXPECT_EQ(shared.report.preconditioning, Preconditioning::multigrid);
    for (std::size_t k = 0; k < 3; ++k) expect_the_same(shared.steps[k], factor.steps[k], 1e-6);
  }
}

TEST_F(SharedPath, GoesOnFromStepsOfTheFactors) {
  const Problem problem = problem_of("tersoff", 30, DiscLoad{6}, {1, 2, 3});
  const Path factor = path_with(Preconditioning::factor, problem);
  std::vector<Step> finished;
  if (leads()) finished.assign(factor.steps.begin(), factor.steps.begin() + 2);
  // Every rank is given them, as from a folder that all of them see.
  for (int k = 0; k < 2; ++k) {
    Step step = leads() ? finished[k] : Step{};
    const MpiTeam team;
    const auto tell = [&](double number) { return team.sum(leads() ? number : 0); };
    const auto size = static_cast<Eigen::Index>(tell(static_cast<double>(step.positions.size())));
    for (VectorXd* v : {&step.positions, &step.factorised_at}) {
      v->conservativeResize(size);
      for (double& number : *v) number = tell(number);
    }
    step.target = tell(step.target);
    step.conjugate_depth_A = tell(step.conjugate_depth_A);
    step.depth_A = tell(step.depth_A);
    step.force_eV_per_A = tell(step.force_eV_per_A);
    step.longest_bond_A = tell(step.longest_bond_A);
    step.evaluations = static_cast<int>(tell(step.evaluations));
    step.factorisations = static_cast<int>(tell(step.factorisations));
    step.converged = true;
    if (leads())
      finished[k] = step;
    else
      finished.push_back(step);
  }
  const Path shared = path_with(Preconditioning::multigrid, problem, finished);
  if (!leads()) return;
  ASSERT_EQ(shared.steps.size(), 1u) << shared.report.reason;
  expect_the_same(shared.steps[0], factor.steps[2], 1e-6);
}

/// Rank r has the numbers 100 r + 10 k + c of atom k; each asks the next rank for its atoms 3 and 1.
TEST_F(SharedPath, AHaloFetchesAndGivesBack) {
  const MpiTeam team;
  const int next = (team.rank() + 1) % team.ranks(), before = (team.rank() + team.ranks() - 1) % team.ranks();
  VectorXd own(12);
  for (int k = 0; k < 12; ++k) own[k] = 100 * team.rank() + 10 * (k / 3) + k % 3;
  const Halo halo(std::vector<Place>{{next, 3}, {next, 1}});
  VectorXd fetched = halo.fetch(own);
  ASSERT_EQ(fetched.size(), 6);
  for (int c = 0; c < 3; ++c) {
    EXPECT_EQ(fetched[c], 100 * next + 30 + c);
    EXPECT_EQ(fetched[3 + c], 100 * next + 10 + c);
  }
  fetched.setConstant(-1 - team.rank());
  halo.give_back(fetched, own);
  for (int c = 0; c < 3; ++c) {
    EXPECT_EQ(own[9 + c], -1 - before);
    EXPECT_EQ(own[3 + c], -1 - before);
    EXPECT_EQ(own[c], 100 * team.rank() + c);
  }
}

}  // namespace
