#include "compare/verdict/explanation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace validate {
namespace {

validate::Run cubic(double stiffness, const std::vector<double>& depths) {
  validate::Run run;
  run.load = LoadKind::disc;
  run.a_A = 100;
  for (const double d : depths) {
    run.depth_A.push_back(d);
    run.conjugate_depth_A.push_back(d);
    run.force_eV_per_A.push_back(stiffness * d * d * d);
    run.converged.push_back(true);
  }
  return run;
}

TEST(Explanation, SharesAddUpToTheWholeDifference) {
  const std::vector<double> grid = {1, 4, 9, 16, 25};
  const validate::Run plain = cubic(1.0, grid), paired = cubic(0.98, grid), bending = cubic(1.2, grid),
                      law = cubic(1.1, grid);
  validate::Run atoms = cubic(1.15, {2, 8, 20, 30});
  atoms.part.emplace<AtomsPart>().artefact = {false, false, true, false};
  const auto found = explain(atoms, {&plain, &paired, &bending, &law}, {{2, 4, 20}, {1.01, 1.02, 1.06}});
  ASSERT_TRUE(found);
  ASSERT_EQ(found->depth_A, (std::vector{2.0, 8.0}));  // 20 is an artefact, 30 beyond the continua
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(found->geometry[i], -0.02, 1e-12);
    EXPECT_NEAR(found->bending[i], 0.22, 1e-12);
    EXPECT_NEAR(found->large_strain[i], -0.10, 1e-12);
    const double directions = 1.1 * (i == 0 ? 0.01 : 0.03);  // interpolated
    EXPECT_NEAR(found->anisotropy[i], directions, 1e-12);
    EXPECT_NEAR(found->remainder[i], 0.05 - directions, 1e-12);
    EXPECT_NEAR(found->plain_force_eV_per_A[i], std::pow(found->depth_A[i], 3), 1e-9);
  }
}

TEST(Explanation, NeedsEveryStage) {
  const validate::Run curve = cubic(1, {1, 5, 9}), nothing = cubic(1, {});
  EXPECT_FALSE(explain(curve, {&curve, &curve, &nothing, &curve}, {}));
  const auto found = explain(curve, {&curve, &curve, &curve, &curve}, {});
  ASSERT_TRUE(found);
  EXPECT_TRUE(std::isnan(found->anisotropy[0]));  // not known: a part of the remainder
  EXPECT_NEAR(found->remainder[0], 0, 1e-12);
}

}  // namespace
}  // namespace validate
