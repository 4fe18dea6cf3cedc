// The multigrid in the place of the factor: in MPI's session, which hypre needs.
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "atomistic/equilibrium/network_factor.hpp"
#include "atomistic/protocol/preconditioning.hpp"
#include "tests/atomistic/support/paths.hpp"

namespace {

using namespace atomistic;
using Eigen::VectorXd;

struct MultigridTest : testing::Test {
  void SetUp() override {
    if (!has_multigrid()) GTEST_SKIP() << "built without hypre";
  }
};

/// A dent as an indenter makes it: tension in the middle, bending alone outside.
VectorXd dented(const Sheet& sheet) {
  VectorXd x = sheet.positions;
  for (int i = 0; i < sheet.atoms(); ++i) {
    const double r = sheet.position(i).norm() / sheet.radius_A;
    x[3 * i + 2] = -3 * std::max(0.0, 1 - r * r);
  }
  return x;
}

struct OneMatrix {
  Card network_card = card_of("tersoff");
  Sheet sheet = make_sheet(30, network_card.a0_A, 0, 4);
  std::unique_ptr<NetworkSolver> cycle =
      make_network_solver(Preconditioning::multigrid, sheet, spring_constants(network_card));
  NetworkFactor factor{sheet, spring_constants(network_card)};

  OneMatrix() {
    cycle->set_up(dented(sheet), {});
    factor.set_up(dented(sheet), {});
  }
};

/// What a metric has to be.
TEST_F(MultigridTest, ACycleIsLinearSymmetricAndPositive) {
  const OneMatrix m;
  const auto n = m.factor.matrix().rows();
  const VectorXd b = VectorXd::Random(n), c = VectorXd::Random(n);
  const VectorXd Mb = m.cycle->solve(b), Mc = m.cycle->solve(c);
  EXPECT_NEAR(b.dot(Mc), c.dot(Mb), 1e-10 * b.dot(Mb));
  EXPECT_GT(b.dot(Mb), 0);
  EXPECT_LT((m.cycle->solve(b - 2 * c) - (Mb - 2 * Mc)).norm(), 1e-11 * Mb.norm());
}

/// Conjugate gradients with one cycle an iteration, to where the factor's answer is: in energy, the measure in which
/// the two are metrics of one minimiser. Without a good cycle they need a thousand iterations.
TEST_F(MultigridTest, FewCyclesSolveWhatTheFactorDoes) {
  const OneMatrix m;
  const auto p = m.factor.matrix().selfadjointView<Eigen::Lower>();
  VectorXd b = VectorXd::Zero(m.factor.matrix().rows());
  for (int atom : m.sheet.record) b[3 * atom + 2] = 1;
  VectorXd exact = m.factor.solve(b);
  exact += m.factor.solve(b - p * exact);
  VectorXd x = VectorXd::Zero(b.size()), r = b, z = m.cycle->solve(r), d = z;
  double rz = r.dot(z);
  int cycles = 1;
  const auto error = [&] { return (x - exact).dot(p * (x - exact)) / exact.dot(b); };
  for (; error() > 1e-12 && cycles < 200; ++cycles) {
    const VectorXd pd = p * d;
    const double step = rz / d.dot(pd);
    x += step * d;
    r -= step * pd;
    z = m.cycle->solve(r);
    const double next = r.dot(z);
    d = z + next / rz * d;
    rz = next;
  }
  EXPECT_LT(error(), 1e-12);
  EXPECT_LE(cycles, 40);
}

TEST_F(MultigridTest, IsMadeAnewForOtherPositions) {
  OneMatrix m;
  const VectorXd b = VectorXd::Random(m.factor.matrix().rows());
  const VectorXd dent = m.cycle->solve(b);
  m.cycle->set_up(m.sheet.positions, {});
  EXPECT_GT((m.cycle->solve(b) - dent).norm(), 1e-3 * dent.norm());
  m.cycle->set_up(dented(m.sheet), {});
  EXPECT_EQ((m.cycle->solve(b) - dent).norm(), 0);
}

Path path_with(Preconditioning kind, Problem problem) {
  problem.preconditioning = kind;
  problem.force_tolerance_eV_per_A = 1e-8;
  return follow(problem);
}

class MultigridPath : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (!has_multigrid()) GTEST_SKIP() << "built without hypre";
  }
};

/// The same equilibria, so the same forces: depths held by projection in the metric of a cycle.
TEST_P(MultigridPath, HasTheForcesOfTheFactors) {
  const Problem problem = problem_of(GetParam(), 30, DiscLoad{5}, {1, 2, 3});
  const Path factor = path_with(Preconditioning::factor, problem);
  const Path multigrid = path_with(Preconditioning::multigrid, problem);
  ASSERT_EQ(factor.steps.size(), 3u);
  ASSERT_EQ(multigrid.steps.size(), 3u) << multigrid.report.reason;
  for (std::size_t k = 0; k < 3; ++k) {
    const double force = factor.steps[k].force_eV_per_A;
    EXPECT_TRUE(multigrid.steps[k].converged);
    EXPECT_NEAR(multigrid.steps[k].force_eV_per_A, force, 1e-6 * force);
    EXPECT_NE(multigrid.steps[k].force_eV_per_A, force) << "it was the same metric";
    EXPECT_GT(multigrid.steps[k].solves, 0);
  }
  EXPECT_EQ(factor.report.preconditioning, Preconditioning::factor);
  EXPECT_EQ(multigrid.report.preconditioning, Preconditioning::multigrid);
}

INSTANTIATE_TEST_SUITE_P(Potentials, MultigridPath, testing::Values("airebo", "rebo", "tersoff", "lcbop"));

/// A sphere of held force takes stiffness out of the matrix again; a disc's dead force has no constraint.
TEST_F(MultigridTest, HeldForcesAreHeldAsWithTheFactor) {
  for (const Load& load : {Load(SphereLoad{.radius_A = 7.5}), Load(DiscLoad{5})}) {
    Problem problem = problem_of("tersoff", 20, load, {0.5, 1});
    problem.control = Control::force;
    const Path factor = path_with(Preconditioning::factor, problem);
    const Path multigrid = path_with(Preconditioning::multigrid, problem);
    ASSERT_EQ(multigrid.steps.size(), 2u) << multigrid.report.reason;
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_NEAR(multigrid.steps[k].depth_A, factor.steps[k].depth_A, 1e-6 * factor.steps[k].depth_A);
  }
}

TEST(Preconditioning, IsChosenByTheNumberOfAtoms) {
  const auto large = has_multigrid() ? Preconditioning::multigrid : Preconditioning::factor;
  EXPECT_EQ(preconditioning_for(Preconditioning::automatic, multigrid_from_atoms), large);
  EXPECT_EQ(preconditioning_for(Preconditioning::automatic, multigrid_from_atoms - 1), Preconditioning::factor);
  EXPECT_EQ(preconditioning_for(Preconditioning::factor, 10 * multigrid_from_atoms), Preconditioning::factor);
}

}  // namespace
