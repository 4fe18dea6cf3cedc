// E·h and pretension of measured points, with their errors.
#include "compare/fitting/inference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compare/base/errors.hpp"
#include "compare/base/field_value.hpp"
#include "compare/base/units.hpp"
#include "compare/fitting/models/eq16.hpp"
#include "compare/fitting/normal.hpp"
#include "compare/fitting/sheet_table.hpp"

using namespace validate;

namespace {

constexpr double Eh = 342 / N_per_m_per_eV_per_A2, pretension = 0.34 / N_per_m_per_eV_per_A2;
constexpr double sigma_force = 5 / nN_per_eV_per_A;
const double truth[] = {Eh, pretension};

ForceModel closed() { return force_model(any_model(Eq16{5000, 0.165})); }

CurvePoints curve(std::uint32_t seed, int count = 120) {
  const AnyCurveModel form = any_model(Eq16{5000, 0.165});
  Normal normal(seed);
  CurvePoints p;
  for (int i = 0; i < count; ++i) {
    const double depth = std::lerp(-150.0, 950.0, i / (count - 1.0));
    p.depth_A.push_back(depth + 10 * normal());
    p.force_eV_per_A.push_back((depth > 0 ? form.value(depth, truth) : 0) + sigma_force * normal());
  }
  p.noise.force_eV_per_A = sigma_force;
  p.noise.depth_A = 10;
  return p;
}

Fit fitted(const CurvePoints& points, InferenceOptions options = {{true, true, false}, {}, true, 0, 1}) {
  const auto found = infer(points, closed(), options);
  if (const auto* reason = std::get_if<std::string>(&found)) throw std::runtime_error(*reason);
  return std::get<Fit>(found);
}

// With free zeros a constant says nothing of the sheet.
TEST(Inference, ConstantsAddedToDepthAndForceChangeNothing) {
  const Fit plain = fitted(curve(2));
  for (const auto& [depth, force] :
       {std::pair(300.0, 0.0), {-300.0, 0.0}, {10000.0, 0.0}, {0.0, 50.0}, {70.0, -20.0}}) {
    CurvePoints shifted = curve(2);
    for (double& d : shifted.depth_A) d += depth;
    for (double& f : shifted.force_eV_per_A) f += force;
    const Fit fit = fitted(shifted);
    EXPECT_NEAR(fit.Eh_eV_per_A2 / plain.Eh_eV_per_A2, 1, 1e-6) << depth << " " << force;
    EXPECT_NEAR(fit.pretension_eV_per_A2 / plain.pretension_eV_per_A2, 1, 1e-6) << depth << " " << force;
    EXPECT_NEAR(*fit.contact_nm - *plain.contact_nm, depth / 10, 1e-4);
    EXPECT_NEAR(*fit.force_zero_nN - *plain.force_zero_nN, force * nN_per_eV_per_A, 1e-4);
  }
}

TEST(Inference, TheOrderOfThePointsIsNothing) {
  const Fit plain = fitted(curve(2));
  CurvePoints turned = curve(2);
  std::ranges::reverse(turned.depth_A);
  std::ranges::reverse(turned.force_eV_per_A);
  std::swap(turned.depth_A[3], turned.depth_A[77]);
  std::swap(turned.force_eV_per_A[3], turned.force_eV_per_A[77]);
  const Fit fit = fitted(turned);
  EXPECT_NEAR(fit.Eh_eV_per_A2 / plain.Eh_eV_per_A2, 1, 1e-6);
  EXPECT_NEAR(fit.Eh_interval_eV_per_A2[1] / plain.Eh_interval_eV_per_A2[1], 1, 1e-5);
  EXPECT_NEAR(fit.runs_z, plain.runs_z, 1e-9);
}

// A scale that is uncertain by 3 % is 3 % of E·h, beside the noise.
TEST(Inference, AnUncertainInputIsInTheInterval) {
  InferenceOptions options{{}, {{"force", scaled(closed(), 1.03)}}, true, 0, 1};
  const Fit exact = fitted(curve(6), {}), fit = fitted(curve(6), options);
  EXPECT_NEAR(fit.Eh_eV_per_A2 / exact.Eh_eV_per_A2, 1, 1e-4);
  const double noise = exact.Eh_stderr_eV_per_A2, scale = 0.03 * exact.Eh_eV_per_A2;
  EXPECT_NEAR(fit.Eh_stderr_eV_per_A2 / std::hypot(noise, scale), 1, 1e-2);
  const double width = fit.Eh_interval_eV_per_A2[1] - fit.Eh_interval_eV_per_A2[0];
  EXPECT_NEAR(width / (2 * 1.96 * std::hypot(noise, scale)), 1, 2e-2);
  const auto source = std::ranges::find(fit.sources, "force", &ErrorSource::name);
  ASSERT_NE(source, fit.sources.end());
  EXPECT_NEAR(source->Eh_eV_per_A2 / scale, 1, 1e-2);
}

// The mean over many curves of χ²/ν is 1.
TEST(Inference, MisfitIsThatOfTheNoise) {
  double sum = 0;
  constexpr int curves = 40;
  for (std::uint32_t seed = 1; seed <= curves; ++seed) sum += fitted(curve(seed)).chi2_per_dof / curves;
  EXPECT_NEAR(sum, 1, 4 * std::sqrt(2.0 / 116 / curves));
}

TEST(Inference, NoiseThatIsNotKnownIsFound) {
  double force = 0, depth = 0;
  constexpr int curves = 20;
  for (std::uint32_t seed = 1; seed <= curves; ++seed) {
    CurvePoints points = curve(seed, 230);
    points.noise.force_eV_per_A.reset();
    points.noise.depth_A.reset();
    const Fit fit = fitted(points);
    force += *fit.sigma_force_nN / curves;
    depth += *fit.sigma_depth_nm / curves;
  }
  EXPECT_NEAR(force / 5, 1, 0.06);
  EXPECT_NEAR(depth / 1, 1, 0.06);
}

TEST(Inference, BootstrapIsTheCovariance) {
  const Fit fit = fitted(curve(11), {{}, {}, true, 1500, 7});
  // 1500 draws: 1.8 % of a standard error, four times
  EXPECT_NEAR(*fit.Eh_bootstrap_eV_per_A2 / fit.Eh_stderr_eV_per_A2, 1, 0.075);
  EXPECT_NEAR(*fit.pretension_bootstrap_eV_per_A2 / fit.pretension_stderr_eV_per_A2, 1, 0.075);
}

TEST(Inference, TheSeedDecides) {
  const auto drawn = [](std::uint32_t seed) {
    return *fitted(curve(3), {{}, {}, true, 30, seed}).Eh_bootstrap_eV_per_A2;
  };
  EXPECT_EQ(drawn(7), drawn(7));
  EXPECT_NE(drawn(7), drawn(8));
}

// The sheet itself, on exact curves of sheets that bend, soften and are pressed by spheres: its own table's error is
// left.
struct Sheet {
  const char* name;
  MembraneTip tip;
  double Eh, pretension, deepest, tolerance;
};

class ExactCurve : public testing::TestWithParam<Sheet> {};

TEST_P(ExactCurve, GivesBackItsConstants) {
  const Sheet& sheet = GetParam();
  std::vector<double> depth;
  for (int i = 1; i <= 20; ++i) depth.push_back(sheet.deepest * i / 20);
  const SheetCurve solved = sheet_curve(sheet.tip, law_of(sheet.tip, sheet.Eh), sheet.pretension, depth);
  ASSERT_TRUE(solved.ended_early.empty()) << solved.ended_early;
  CurvePoints points{solved.depth_A, solved.force_eV_per_A, {}};
  points.noise.force_eV_per_A = 1e-3 * solved.force_eV_per_A.back();
  const ForceModel table =
      sheet_table(sheet.tip, {1.05 * sheet.deepest, 1.05 * sheet.Eh, 1.5 * sheet.pretension / sheet.Eh});
  const auto found = infer(points, table, {});
  ASSERT_TRUE(std::holds_alternative<Fit>(found)) << std::get<std::string>(found);
  const Fit& fit = std::get<Fit>(found);
  EXPECT_NEAR(fit.Eh_eV_per_A2 / sheet.Eh, 1, sheet.tolerance);
  EXPECT_NEAR(fit.pretension_eV_per_A2 / sheet.pretension, 1, 10 * sheet.tolerance);
}

INSTANTIATE_TEST_SUITE_P(
    Sheets, ExactCurve,
    testing::Values(Sheet{"point", {5000, 0.165, 0}, Eh, pretension, 1000, 5e-4},
                    Sheet{"disc", {5000, 0.165, 165}, Eh, pretension, 1000, 5e-4},
                    Sheet{"sphere", {5000, 0.165, 165, 0, true}, Eh, pretension, 1000, 5e-4},
                    Sheet{"large_sphere_slack", {5000, 0.165, 275, 0, true}, Eh, 0.2 * pretension, 1000, 5e-4},
                    Sheet{"third_order",
                          {5000, 0.165, 165, 0, false, third_order_physics(0.165, -690 / N_per_m_per_eV_per_A2, 1.4)},
                          Eh,
                          pretension,
                          1000,
                          1e-3},
                    Sheet{"small_and_bent",
                          {111.05, 0.3645, 10.08, 1.4, false,
                           calibrated_physics({17.3356, 0.3645, {{3, 0, -15.8}, {1, 2, -60}}}, 0.967, "airebo")},
                          17.3356,
                          0.02,
                          24,
                          2e-3}),
    [](const auto& test) { return test.param.name; });

// 12 above and 10 below in 6 runs, where 2·12·10/22 + 1 = 11.909 are expected, with a variance of
// 240 (240 − 22)/(22² 21) = 5.1476.
TEST(RunsZ, IsWaldAndWolfowitzs) {
  std::vector<double> residuals;
  for (const int run : {4, -3, 5, -4, 3, -3})
    for (int i = 0; i < std::abs(run); ++i) residuals.push_back(run);
  EXPECT_NEAR(runs_z(residuals), (11.909091 - 6) / std::sqrt(5.147580), 1e-5);
  residuals.pop_back();
  EXPECT_TRUE(std::isnan(runs_z(residuals))) << "nine below";
}

TEST(Inference, SaysWhyItFails) {
  CurvePoints two{{10, 20}, {1, 2}, {}};
  two.noise.force_eV_per_A = 1;
  const auto found = infer(two, closed(), {});
  ASSERT_TRUE(std::holds_alternative<std::string>(found));
  EXPECT_EQ(std::get<std::string>(found), "2 points for 2 parameters");
}

TEST(Uncertain, IsReadInEveryWayItIsWritten) {
  const Field radius{"radius", unit::length, "radius", positive()};
  for (const char* text :
       {"0.50 ± 0.01 um", "0.5 um ± 2 %", "0.5 um +- 0.01 um", "0.5 um +/- 100 Å", "500 nm ± 2%", "0.5 ± 2 % um"}) {
    const Uncertain read = parse_uncertain(radius, text, "--radius");
    EXPECT_NEAR(read.value, 5000, 1e-9) << text;
    EXPECT_NEAR(read.error, 100, 1e-9) << text;
  }
  EXPECT_EQ(parse_uncertain(radius, "0.5 um", "--radius").error, 0);
  const Field share{"nu", unit::none, "", between(-1, 1)};
  EXPECT_NEAR(parse_uncertain(share, "-0.2 ± 0.03", "--nu").error, 0.03, 1e-12);
  EXPECT_NEAR(parse_uncertain(share, "-0.2 ± 10 %", "--nu").error, 0.02, 1e-12);
}

// A value that is larger by its error must be in range, too; a unit may begin with what looks like an exponent.
TEST(Uncertain, StaysInRangeAndReadsUnitsThatBeginWithE) {
  const Field nu{"nu", unit::none, "", between(-1, 1)},
      stiffness{"spring-constant", unit::membrane_force, "", positive()};
  EXPECT_THROW(parse_uncertain(nu, "0.165 ± 2", "--nu"), Error);
  const Uncertain read = parse_uncertain(stiffness, "2 ± 0.1 eV/A^2", "--spring-constant");
  EXPECT_NEAR(read.value, 2, 1e-12);
  EXPECT_NEAR(read.error, 0.1, 1e-12);
  EXPECT_NEAR(parse_uncertain(stiffness, "16.02176634 N/m ± 1.602176634", "--spring-constant").error, 0.1, 1e-12);
}

TEST(Uncertain, RefusesWhatIsNone) {
  const Field radius{"radius", unit::length, "radius", positive()};
  for (const char* text : {"0.5 um ±", "± 0.01 um", "0.5 um ± -0.01 um", "0.5 um ± -2 %", "0.5 um ± x",
                           "-0.5 ± 0.01 um", "0.5 um ± nan um", "0.5 um ± 0.01 um ± 2", "0.5 nN ± 1 nN"})
    EXPECT_THROW(parse_uncertain(radius, text, "--radius"), Error) << text;
}

}  // namespace
