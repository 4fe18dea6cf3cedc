#include "compare/verdict/regimes.hpp"

#include <gtest/gtest.h>

#include "compare/documents/texts/regime_text.hpp"

namespace validate {
namespace {

// One depth each: bending alone, the two that cancel, softening (with what bending there is), hardening, nothing, the
// artefact zone.
Explanation parts() {
  Explanation e;
  e.depth_A = {1, 2, 3, 4, 5, 6};
  e.geometry = {0.5, 0.5, 0.5, 0.5, 0.5, 0.5};  // the same in the membrane that is compared with
  e.bending = {0.2, 0.09, 0.02, 0.01, 0.01, 0.0};
  e.large_strain = {-0.01, -0.1, -0.07, 0.1, -0.01, -0.3};
  return e;
}

Comparison ratios() {
  Comparison c;
  c.depth_A = parts().depth_A;
  c.force_ratio = {1.2, 0.99, 0.8, 1.1, 1, 0.7};
  return c;
}

const std::vector<bool> artefacts = {false, false, false, false, false, true};

TEST(Regimes, AreTheLargestContribution) {
  const Explanation e = parts();
  EXPECT_EQ(regimes_of(ratios(), artefacts, &e, 0.06),
            (std::vector{Regime::bending, Regime::cancellation, Regime::softening, Regime::hardening, Regime::membrane,
                         Regime::artefact}));
}

TEST(Regimes, AreTheRatiosWithoutAnExplanation) {
  const std::vector<Regime> by_ratio = {Regime::bending, Regime::membrane, Regime::softening,
                                        Regime::bending, Regime::membrane, Regime::artefact};
  EXPECT_EQ(regimes_of(ratios(), artefacts, nullptr, 0.06), by_ratio);
  Explanation elsewhere = parts();
  for (double& depth : elsewhere.depth_A) depth += 0.5;
  EXPECT_EQ(regimes_of(ratios(), artefacts, &elsewhere, 0.06), by_ratio);
}

TEST(Regimes, AreToldByWhereTheyEnd) {
  Comparison c;
  c.depth_A = {1, 2, 3.25};
  c.regime = {Regime::bending, Regime::bending, Regime::cancellation};
  EXPECT_EQ(regime_text(c),
            "bending dominates up to 2 Å, bending and the law's curvature cancel each other up to 3.25 Å");
}

}  // namespace
}  // namespace validate
