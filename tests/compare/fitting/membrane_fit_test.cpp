// The membrane itself fitted to synthetic curves whose E·h and pretension are known.
#include "compare/fitting/membrane_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <variant>

#include "compare/base/units.hpp"
#include "compare/fitting/models/eq16.hpp"
#include "compare/fitting/models/list.hpp"
#include "compare/fitting/run_fit.hpp"

using namespace validate;

namespace {

// A graphene drum of 0.5 µm radius (Lee et al., Science 321 (2008) 385: 342 N/m).
constexpr double Eh_N_per_m = 342;

std::vector<double> depths() {
  std::vector<double> d;
  for (int i = 1; i <= 20; ++i) d.push_back(50.0 * i);
  return d;
}

struct Synthetic {
  const char* name;
  double tip_A, pretension_N_per_m;
  bool sphere;
  double low,
      high;  ///< what Eq. 16 reads over the true pretension, minus 1: the range published for such tips
};

class Drum : public testing::TestWithParam<Synthetic> {};

TEST_P(Drum, GivesBackItsConstants) {
  const Synthetic& asked = GetParam();
  const MembraneTip tip{5000, 0.165, asked.tip_A, 0, asked.sphere};
  const double Eh = Eh_N_per_m / N_per_m_per_eV_per_A2, pretension = asked.pretension_N_per_m / N_per_m_per_eV_per_A2;
  const auto d = depths();
  const auto force = membrane_forces(tip, Eh, pretension, d);

  const MembraneFitReport direct = fit_membrane(tip, d, force, {});
  ASSERT_TRUE(direct.converged) << direct.reason;
  EXPECT_NEAR(direct.fit.Eh_eV_per_A2 / Eh, 1, 5e-4);
  EXPECT_NEAR(direct.fit.pretension_eV_per_A2 / pretension, 1, 5e-3);
  EXPECT_LE(direct.iterations, 20);

  // Eq. 16 does not: it misses a quarter to all of the pretension, and its sign with a large sphere at 0.07
  // N/m.
  const auto eq16 = std::get<Fit>(fit_curve(any_model(Eq16{5000, 0.165}), d, force));
  EXPECT_GT(eq16.pretension_eV_per_A2 / pretension - 1, asked.low);
  EXPECT_LT(eq16.pretension_eV_per_A2 / pretension - 1, asked.high);
  EXPECT_LT(eq16.rms_relative, 0.005) << "and the residuals do not show it";
}

INSTANTIATE_TEST_SUITE_P(Curves, Drum,
                         testing::Values(Synthetic{"point_007", 0, 0.07, false, -0.44, -0.24},
                                         Synthetic{"point_034", 0, 0.34, false, -0.44, -0.24},
                                         Synthetic{"point_074", 0, 0.74, false, -0.44, -0.24},
                                         Synthetic{"disc_007", 165, 0.07, false, -0.44, -0.2},
                                         Synthetic{"disc_034", 165, 0.34, false, -0.44, -0.2},
                                         Synthetic{"disc_074", 165, 0.74, false, -0.44, -0.24},
                                         Synthetic{"sphere165_007", 165, 0.07, true, -0.9, -0.6},
                                         Synthetic{"sphere165_034", 165, 0.34, true, -0.44, -0.24},
                                         Synthetic{"sphere165_074", 165, 0.74, true, -0.44, -0.24},
                                         Synthetic{"sphere275_007", 275, 0.07, true, -2, -1}),
                         [](const auto& test) { return test.param.name; });

// The curve is made by the shallow closed form, which the finite-strain solver knows nothing of: at depths of
// up to 0.1 of the radius both are the same theory to a few parts in 10⁴, so this is not a model fitted to
// itself.
TEST(MembraneFit, AgreesWithTheShallowTheoryWhereThatHolds) {
  const MembraneTip tip{5000, 0.165, 165, 0};
  const double truth[] = {Eh_N_per_m / N_per_m_per_eV_per_A2, 0.34 / N_per_m_per_eV_per_A2};
  const AnyCurveModel shallow = closed_form("foeppl", "").make({5000, 0.165, 165, 0});
  std::vector<double> d, f;
  for (int i = 1; i <= 20; ++i) {
    d.push_back(25.0 * i);
    f.push_back(shallow.value(d.back(), truth));
  }
  const MembraneFitReport direct = fit_membrane(tip, d, f, {});
  ASSERT_TRUE(direct.converged) << direct.reason;
  EXPECT_NEAR(direct.fit.Eh_eV_per_A2 / truth[0], 1, 5e-3);
  EXPECT_NEAR(direct.fit.pretension_eV_per_A2 / truth[1], 1, 5e-3);
}

TEST(MembraneFit, NoiseWidensTheErrorsNotTheTruth) {
  const MembraneTip tip{5000, 0.165, 165, 0};
  const double Eh = Eh_N_per_m / N_per_m_per_eV_per_A2, pretension = 0.34 / N_per_m_per_eV_per_A2;
  const auto d = depths();
  auto force = membrane_forces(tip, Eh, pretension, d);
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 2 / nN_per_eV_per_A);
  for (double& f : force) f += noise(random);
  const MembraneFitReport direct = fit_membrane(tip, d, force, {});
  ASSERT_TRUE(direct.converged) << direct.reason;
  EXPECT_LT(std::abs(direct.fit.Eh_eV_per_A2 - Eh), 4 * direct.fit.Eh_stderr_eV_per_A2);
  EXPECT_LT(std::abs(direct.fit.pretension_eV_per_A2 - pretension), 4 * direct.fit.pretension_stderr_eV_per_A2);
  EXPECT_GT(direct.fit.Eh_stderr_eV_per_A2, 1e-4 * Eh);
}

/// A sheet that softens and bends is fitted by itself; the paper's membrane misreads it.
TEST(MembraneFit, ASheetOfThirdOrderGivesBackItsConstants) {
  const double Eh = Eh_N_per_m / N_per_m_per_eV_per_A2, pretension = 0.34 / N_per_m_per_eV_per_A2;
  const double D = -690 / N_per_m_per_eV_per_A2;
  MembraneTip sheet{5000, 0.165, 165, 0};
  sheet.physics = third_order_physics(0.165, D, 1.4);
  const auto d = depths();
  const auto force = membrane_forces(sheet, Eh, pretension, d);
  const MembraneFitReport direct = fit_membrane(sheet, d, force, {});
  ASSERT_TRUE(direct.converged) << direct.reason;
  EXPECT_NEAR(direct.fit.Eh_eV_per_A2 / Eh, 1, 5e-4);
  EXPECT_NEAR(direct.fit.pretension_eV_per_A2 / pretension, 1, 5e-3);
  MembraneTip plain = sheet;
  plain.physics.reset();
  const MembraneFitReport misread = fit_membrane(plain, d, force, {});
  ASSERT_TRUE(misread.converged) << misread.reason;
  EXPECT_LT(misread.fit.Eh_eV_per_A2 / Eh, 0.99);
}

/// A curve that goes on where the sheet of the law would have torn is fitted up to there.
TEST(MembraneFit, ASheetThatTearsIsFittedAsFarAsItGoes) {
  const double Eh = Eh_N_per_m / N_per_m_per_eV_per_A2, pretension = 0.34 / N_per_m_per_eV_per_A2;
  MembraneTip sheet{5000, 0.165, 165, 0, true};
  sheet.physics = third_order_physics(0.165, -1200 / N_per_m_per_eV_per_A2, 1.4);
  std::vector<double> d;
  for (int i = 1; i <= 40; ++i) d.push_back(25.0 * i);
  SheetCurve curve = sheet_curve(sheet, sheet.physics->law(Eh), pretension, d);
  ASSERT_FALSE(curve.ended_early.empty());
  const double end = curve.depth_A.back(), force = curve.force_eV_per_A.back();
  ASSERT_GT(end, 500);
  for (const double deeper : {1.05, 1.1, 1.15}) {
    curve.depth_A.push_back(deeper * end);
    curve.force_eV_per_A.push_back(deeper * deeper * deeper * force);
  }
  const MembraneFitReport direct = fit_membrane(sheet, curve.depth_A, curve.force_eV_per_A, {});
  ASSERT_TRUE(direct.converged) << direct.reason;
  ASSERT_TRUE(direct.fit.torn_at_A);
  EXPECT_NEAR(*direct.fit.torn_at_A / end, 1, 0.08);
  EXPECT_EQ(direct.fit.fitted_depth_A.size(), direct.fit.model_force_eV_per_A.size());
  EXPECT_LT(direct.fit.fitted_depth_A.size(), curve.depth_A.size() - 2);
  EXPECT_NEAR(direct.fit.Eh_eV_per_A2 / Eh, 1, 5e-4);
  EXPECT_NEAR(direct.fit.pretension_eV_per_A2 / pretension, 1, 5e-3);
}

/// 110 Å of AIREBO-like graphene: bending is most of the force at first.
TEST(MembraneFit, ASmallSheetThatBendsGivesBackItsConstants) {
  membrane::CauchyBorn law{17.3356, 0.3645, {{3, 0, -15.8}, {1, 2, -60}}};
  MembraneTip sheet{111.05, 0.3645, 10.08, 1.4};
  sheet.physics = calibrated_physics(law, 0.967, "airebo");
  std::vector<double> d;
  for (int i = 1; i <= 12; ++i) d.push_back(2.0 * i);
  const auto force = membrane_forces(sheet, 17.3356, 0.02, d);
  const MembraneFitReport direct = fit_membrane(sheet, d, force, {});
  ASSERT_TRUE(direct.converged) << direct.reason;
  EXPECT_NEAR(direct.fit.Eh_eV_per_A2 / 17.3356, 1, 2e-3);
  EXPECT_NEAR(direct.fit.pretension_eV_per_A2 / 0.02, 1, 2e-2);
}

TEST(MembraneFit, SaysWhyItFails) {
  const MembraneTip tip{5000, 0.165, 165, 0};
  const MembraneFitReport two = fit_membrane(tip, {10, 20}, {1, 2}, {});
  EXPECT_FALSE(two.converged);
  EXPECT_EQ(two.reason, "2 points for 2 parameters");
}

}  // namespace
