#include "compare/process/atoms_budget.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "atomistic/protocol/preconditioning.hpp"
#include "compare/base/errors.hpp"
#include "compare/base/memory.hpp"

namespace {

using namespace validate;

atomistic::Potential tersoff() {
  atomistic::Potential potential;
  potential.pair_style = "tersoff";
  potential.interaction_range_A = 4.5;
  return potential;
}

AtomsBudget budget_of(double radius_A, Preconditioner preconditioner) {
  Case c;
  c.radius_A = radius_A;
  c.preconditioner = preconditioner;
  return atoms_budget(c, tersoff(), 1);
}

/// Peak memory of one depth with Tersoff, measured (atomistic_scale), to 30 %.
TEST(AtomsBudget, SaysTheMemoryThatWasMeasured) {
  struct Measured {
    double radius_A;
    Preconditioner preconditioner;
    double GB;
  };
  for (const auto& [radius_A, preconditioner, GB] : {Measured{110, Preconditioner::factor, 0.19},
                                                     {300, Preconditioner::factor, 1.05},
                                                     {110, Preconditioner::multigrid, 0.14},
                                                     {300, Preconditioner::multigrid, 0.53},
                                                     {600, Preconditioner::multigrid, 2.02},
                                                     {1000, Preconditioner::multigrid, 5.70},
                                                     {1400, Preconditioner::multigrid, 11.01}})
    EXPECT_NEAR(1e-9 * budget_of(radius_A, preconditioner).memory_bytes / GB, 1, 0.3) << radius_A;
}

/// One depth with Tersoff on one core, all of it, measured in processor time.
TEST(AtomsBudget, SaysTheTimeThatWasMeasured) {
  EXPECT_NEAR(budget_of(300, Preconditioner::factor).all_s() / 4.6, 1, 0.3);
  EXPECT_NEAR(budget_of(300, Preconditioner::multigrid).all_s() / 5.0, 1, 0.3);
  EXPECT_NEAR(budget_of(600, Preconditioner::multigrid).all_s() / 20.3, 1, 0.3);
}

TEST(AtomsBudget, GrowsWithTheLevelsAndTheSheet) {
  Case c;
  const AtomsBudget one = atoms_budget(c, tersoff(), 10), two = atoms_budget(c, tersoff(), 20);
  EXPECT_NEAR(two.forces_s, 2 * one.forces_s, 1e-9 * two.forces_s);
  EXPECT_GT(two.solves_s, one.solves_s);
  EXPECT_GT(budget_of(600, Preconditioner::factor).set_ups_s / budget_of(300, Preconditioner::factor).set_ups_s, 7);
  EXPECT_NEAR(budget_of(600, Preconditioner::multigrid).set_ups_s / budget_of(300, Preconditioner::multigrid).set_ups_s,
              4, 0.1);
}

/// A limit of this process's memory, which others that it starts would inherit.
class Limit {
 public:
  explicit Limit(double bytes) {
    ::getrlimit(RLIMIT_AS, &before_);
    rlimit limit = before_;
    limit.rlim_cur = static_cast<rlim_t>(bytes);
    ::setrlimit(RLIMIT_AS, &limit);
  }
  ~Limit() { ::setrlimit(RLIMIT_AS, &before_); }
  Limit(const Limit&) = delete;
  Limit& operator=(const Limit&) = delete;

 private:
  rlimit before_{};
};

TEST(AtomsBudget, CurvesRunSideBySideOnlyWhereBothFit) {
  const AtomsBudget budget = budget_of(300, Preconditioner::factor);
  const AtomsLaunch launch{.cores = 2};
  const Limit limit(1.5 * budget.memory_bytes);
  EXPECT_EQ(curves_at_once(budget, launch, 2), 1);
  EXPECT_EQ(curves_at_once(budget, {.launcher = {"srun"}}, 2), 2) << "machines of their own";
  const Limit wider(2.2 * budget.memory_bytes);
  EXPECT_EQ(curves_at_once(budget, launch, 2), 2);
}

TEST(AtomsBudget, WhatDoesNotFitIsRefusedWithTheWaysOut) {
  Case c;
  c.radius_A = 300;
  c.preconditioner = Preconditioner::factor;
  const Limit limit(0.8e9);
  try {
    require_memory(c, tersoff(), {});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_code(), ExitCode::bad_input);
    const std::string said = error.what();
    for (const char* word : {"300 Å", "GB with the factor", "0.8 GB are free", "--radius", "--launcher"})
      EXPECT_NE(said.find(word), std::string::npos) << word << ": " << said;
    EXPECT_EQ(said.find("--preconditioner multigrid") != std::string::npos, atomistic::has_multigrid());
  }
  EXPECT_NO_THROW(require_memory(c, tersoff(), {.launcher = {"srun"}}));
  c.radius_A = 110;
  EXPECT_NO_THROW(require_memory(c, tersoff(), {}));
}

TEST(Memory, IsWhatIsLeftOfTheLimits) {
  const auto all = available_memory_bytes();
  ASSERT_TRUE(all);
  EXPECT_GT(*all, 0);
  const Limit limit(0.5e9);
  EXPECT_LE(*available_memory_bytes(), 0.5e9);
}

}  // namespace
