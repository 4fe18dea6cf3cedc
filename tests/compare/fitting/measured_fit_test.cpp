// Measured curves: what is read from a file, what is found in it, and what is said of it.
#include "compare/fitting/measured_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "compare/base/errors.hpp"
#include "compare/base/units.hpp"
#include "compare/fitting/fit_warnings.hpp"
#include "compare/instruments/measured.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace validate;

namespace {

class Measured : public testing::Test {
 protected:
  MeasuredCurve read(const std::string& content, const ColumnChoice& choice = {}) const {
    write_to("curve.csv", content);
    return read_measured(folder_ / "curve.csv", {.columns = choice}).at(0);
  }
  std::string refusal(const std::string& content, const ColumnChoice& choice = {}) const {
    try {
      read(content, choice);
    } catch (const Error& error) {
      EXPECT_EQ(error.exit_code(), ExitCode::bad_input);
      return error.what();
    }
    return "accepted";
  }
  void write_to(const std::string& name, const std::string& content) const { std::ofstream(folder_ / name) << content; }
  TemporaryFolder folder_;
};

TEST_F(Measured, UnitsComeFromTheHeader) {
  for (const char* header : {"depth_nm,force_nN", "Depth (nm),Force (nN)", "indentation [nm], load [nN]",
                             "depth nm,force nN", "depth/nm,force/nN"}) {
    const MeasuredCurve curve = read(std::string(header) + "\n2.5,10\n+5e0,20.5\n");
    ASSERT_EQ(curve.depth_A.size(), 2u) << header;
    EXPECT_DOUBLE_EQ(curve.depth_A[0], 25) << header;
    EXPECT_DOUBLE_EQ(curve.depth_A[1], 50) << header;
    EXPECT_NEAR(curve.force_eV_per_A[1], 20.5 / nN_per_eV_per_A, 1e-12) << header;
    EXPECT_TRUE(curve.sigma_eV_per_A.empty());
  }
}

TEST_F(Measured, TheProgramsOwnCurvesCanBeRead) {
  const MeasuredCurve curve =
      read("# run.0.model: membrane\nrun,depth_A,conjugate_depth_A,force_eV_per_A\n0,2,1.9,0.5\n");
  EXPECT_DOUBLE_EQ(curve.depth_A.at(0), 2);
  EXPECT_DOUBLE_EQ(curve.force_eV_per_A.at(0), 0.5);
}

TEST_F(Measured, ColumnsCanBeChosenAndSeparatorsVary) {
  const std::string content = "# radius: 0.5 um\n\nz_um;x_nm;F_uN;sigma_nN\n1;2;3;4\n";
  const MeasuredCurve by_name = read(content, {"z_um", "F", ""}), by_number = read(content, {"1", "3", "4"});
  EXPECT_DOUBLE_EQ(by_name.depth_A.at(0), 1e4);
  EXPECT_NEAR(by_name.force_eV_per_A[0], 3000 / nN_per_eV_per_A, 1e-9);
  EXPECT_EQ(by_name.depth_A, by_number.depth_A);
  EXPECT_EQ(by_name.sigma_eV_per_A, by_number.sigma_eV_per_A);
  EXPECT_EQ(by_name.remarks.at("radius"), "0.5 um");
  EXPECT_DOUBLE_EQ(read("depth_nm\tforce_nN\n1\t2\n").depth_A.at(0), 10);
}

TEST_F(Measured, WhatIsWrongIsNamedWithItsLine) {
  const auto expect = [&](const std::string& content, std::initializer_list<const char*> words,
                          const ColumnChoice& choice = {}) {
    const std::string message = refusal(content, choice);
    for (const char* word : words)
      EXPECT_NE(message.find(word), std::string::npos) << word << " is not in: " << message;
  };
  expect("", {"empty"});
  expect("depth,force_nN\n1,2\n", {":1:", "'depth' has no unit", "depth_nm"});
  expect("depth_kg,force_nN\n1,2\n", {"no unit that a length"});
  expect("breadth_nm,force_nN\n1,2\n", {"no column for depth", "breadth_nm", "--depth-column"});
  expect("depth_nm,force_nN\n1,2\n2,x\n", {":3:", "'x'", "force_nN"});
  expect("depth_nm,force_nN\n1,2,3\n", {":2:", "3 cells", "2"});
  expect("depth_nm,force_nN\n1,2\n", {"--force-column", "forse_nN", "'force_nN'?"}, {"", "forse_nN", ""});
  expect("depth_nm,force_nN\n1,2\n", {"no column 3"}, {"", "3", ""});
  expect("depth_nm,force_nN,sigma_nN\n1,2,0\n", {"standard deviation"});
  EXPECT_THROW(read_measured(folder_ / "none.csv", {}), Error);
}

TEST_F(Measured, ARowThatIsNotFiniteIsSkippedWithANote) {
  const MeasuredCurve curve = read("depth_nm,force_nN\n1,2\n2,nan\n3,6\n");
  EXPECT_EQ(curve.depth_A.size(), 2u);
  ASSERT_EQ(curve.notes.size(), 1u);
  EXPECT_NE(curve.notes[0].find("1 rows"), std::string::npos) << curve.notes[0];
}

/// A sheet's cubic to 100 nm and back, with a little adhesion on the way back.
std::string cycle(double force_sign, const char* name = "depth") {
  std::string text = fmt::format("{} (nm),force (nN)\n", name);
  for (int i = -20; i <= 100; ++i) text += fmt::format("{},{}\n", i, force_sign * (i > 0 ? 1e-3 * i * i * i : 0));
  for (int i = 99; i >= -20; --i) text += fmt::format("{},{}\n", i, force_sign * (i > 0 ? 1e-3 * i * i * i - 20 : 0));
  return text;
}

TEST_F(Measured, OfACycleInOneTableTheApproachIsTaken) {
  for (const char* name : {"depth", "deflection", "height"}) {
    const MeasuredCurve curve = read(cycle(1, name));
    EXPECT_EQ(curve.depth_A.size(), 121u) << name;
    EXPECT_GE(*std::ranges::min_element(curve.force_eV_per_A), 0) << name;
  }
}

TEST_F(Measured, AForceOfTheOtherSignIsTurned) {
  const MeasuredCurve curve = read(cycle(-1));
  EXPECT_NEAR(*std::ranges::max_element(curve.force_eV_per_A), 1000 / nN_per_eV_per_A, 1e-9);
  EXPECT_TRUE(
      std::ranges::any_of(curve.notes, [](const std::string& note) { return note.find("sign") != std::string::npos; }));
}

TEST_F(Measured, HeightsGrowTowardsTheSampleWhateverTheirSign) {
  for (const double sign : {1.0, -1.0}) {
    std::string text = "height (nm),force (nN)\n";
    for (int i = -40; i <= 60; ++i) text += fmt::format("{},{}\n", sign * i, i > 0 ? 0.5 * i : 0);
    const MeasuredCurve curve = read(text);
    EXPECT_TRUE(curve.depth_from_height);
    EXPECT_NEAR(*std::ranges::max_element(curve.depth_A), 600, 1e-9) << sign;
  }
}

MeasuredOptions drum(double tip_A = 165) {
  MeasuredOptions options;
  options.geometry = {5000, 0.165, tip_A, 0};
  options.sphere = false;
  return options;
}

MeasuredCurve synthetic(double contact_A, double zero_eV_per_A) {
  const double truth[] = {21.35, 0.0212};
  const AnyCurveModel model = closed_form("foeppl", "").make(drum().geometry);
  MeasuredCurve curve;
  curve.file = "synthetic.csv";
  for (double d = -195; d <= 800; d += 15) {
    curve.depth_A.push_back(d + contact_A);
    curve.force_eV_per_A.push_back(zero_eV_per_A + (d > 0 ? model.value(d, truth) : 0));
  }
  return curve;
}

TEST(MeasuredFit, ZerosAreFoundOrTakenOff) {
  MeasuredOptions options = drum();
  options.model = "foeppl";
  options.contact_A = 40;
  options.baseline_to_A = 20;
  const FittedCurve given = evaluate(synthetic(40, 3), options);
  EXPECT_NEAR(given.baseline_eV_per_A, 3, 1e-12);
  EXPECT_NEAR(closed_form_fit(given.fits)->Eh_eV_per_A2 / 21.35, 1, 1e-6);
  EXPECT_NEAR(closed_form_fit(given.fits)->pretension_eV_per_A2 / 0.0212, 1, 1e-5);
  options.contact_A = 0;
  options.free.contact = options.free.force_zero = true;
  options.baseline_to_A.reset();
  const FittedCurve found = evaluate(synthetic(40, 3), options);
  ASSERT_TRUE(closed_form_fit(found.fits));
  const Fit& fit = *closed_form_fit(found.fits);
  EXPECT_NEAR(*fit.contact_nm, 4, 0.1);
  EXPECT_NEAR(*fit.force_zero_nN, 3 * nN_per_eV_per_A, 0.05);
  EXPECT_GT(*fit.contact_stderr_nm, 0);
  EXPECT_NEAR(fit.Eh_eV_per_A2 / 21.35, 1, 5e-3);
}

TEST(MeasuredFit, AConstantAddedToDepthAndForceChangesNothing) {
  MeasuredOptions options = drum();
  options.free.contact = options.free.force_zero = true;
  options.sigma_force_eV_per_A = 1;
  options.sigma_depth_A = 5;
  const FittedCurve here = evaluate(synthetic(40, 3), options), there = evaluate(synthetic(-260, -11), options);
  ASSERT_EQ(here.fits.size(), 2u) << here.skipped;
  ASSERT_EQ(there.fits.size(), 2u) << there.skipped;
  for (std::size_t i = 0; i < here.fits.size(); ++i) {
    EXPECT_NEAR(there.fits[i].Eh_eV_per_A2 / here.fits[i].Eh_eV_per_A2, 1, 1e-7) << here.fits[i].model;
    EXPECT_NEAR(there.fits[i].pretension_eV_per_A2 / here.fits[i].pretension_eV_per_A2, 1, 1e-6);
    EXPECT_NEAR(there.fits[i].Eh_interval_eV_per_A2[0] / here.fits[i].Eh_interval_eV_per_A2[0], 1, 1e-6);
    EXPECT_NEAR(*there.fits[i].contact_nm - *here.fits[i].contact_nm, -30, 1e-5);
  }
}

TEST(MeasuredFit, TheBiasOfTheClosedFormIsSaid) {
  const FittedCurve result = evaluate(synthetic(0, 0), drum());
  const Fit *fit = closed_form_fit(result.fits), *quoted = recommended_fit(result.fits);
  ASSERT_TRUE(fit && fit->bias && quoted) << result.skipped;
  EXPECT_GT(fit->Eh_eV_per_A2 / 21.35, 1.15);
  EXPECT_NEAR(fit->bias->Eh_read_eV_per_A2 / fit->Eh_eV_per_A2, 1, 1e-3);
  EXPECT_EQ(quoted->model, fitted_membrane);
  EXPECT_NEAR(quoted->Eh_eV_per_A2 / 21.35, 1, 0.005);
}

TEST(MeasuredFit, AnUncertainRadiusIsTwiceAsUncertainInTheModulus) {
  MeasuredOptions options = drum();
  options.sigma_force_eV_per_A = 0.1;
  options.sigma_depth_A = 0;
  options.errors.geometry.a_A = 50;  // 1 %
  options.errors.force_scale_relative = 0.03;
  const FittedCurve result = evaluate(synthetic(0, 0), options);
  const Fit* fit = closed_form_fit(result.fits);
  ASSERT_TRUE(fit);
  const auto share = [&](const char* name) {
    const auto source = std::ranges::find(fit->sources, name, &ErrorSource::name);
    return source == fit->sources.end() ? 0 : source->Eh_eV_per_A2 / fit->Eh_eV_per_A2;
  };
  EXPECT_NEAR(share("radius"), 0.02, 3e-4);
  EXPECT_NEAR(share("spring constant"), 0.03, 1e-3);
  EXPECT_NEAR(fit->Eh_stderr_eV_per_A2 / fit->Eh_eV_per_A2, std::hypot(0.02, 0.03), 1e-3);
}

TEST(MeasuredFit, HeightsBecomeDepths) {
  MeasuredOptions options = drum();
  options.model = "foeppl";
  options.spring_constant_eV_per_A2 = 0.5;
  MeasuredCurve curve = synthetic(0, 0);
  curve.depth_from_height = true;
  for (std::size_t i = 0; i < curve.depth_A.size(); ++i) curve.depth_A[i] += curve.force_eV_per_A[i] / 0.5;
  EXPECT_NEAR(closed_form_fit(evaluate(curve, options).fits)->Eh_eV_per_A2 / 21.35, 1, 1e-6);
  options.spring_constant_eV_per_A2.reset();
  EXPECT_THROW(evaluate(curve, options), Error);
}

TEST(MeasuredFit, RefusesWhatCannotBeFitted) {
  MeasuredOptions options = drum();
  options.depth_min_A = 790;
  EXPECT_THROW(evaluate(synthetic(0, 0), options), Error);
  options = drum();
  options.weighting = Weighting::sigma;
  EXPECT_THROW(evaluate(synthetic(0, 0), options), Error);
  MeasuredCurve pulled = synthetic(0, 0);
  for (double& f : pulled.force_eV_per_A) f = -f;
  EXPECT_THROW(evaluate(pulled, drum()), Error);
}

bool says(const std::vector<std::string>& warnings, const std::string& words) {
  return std::ranges::any_of(warnings, [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

Fit good_fit() {
  Fit fit;
  fit.Eh_eV_per_A2 = 20;
  fit.pretension_eV_per_A2 = 0.02;
  fit.pretension_stderr_eV_per_A2 = 0.001;
  fit.rms_relative = 0.001;
  fit.points = 20;
  fit.window_A = {1, 20};
  return fit;
}

TEST(FitWarnings, NoneForAFitWithoutReproach) { EXPECT_TRUE(fit_warnings(good_fit(), {.a_A = 110}).empty()); }

TEST(FitWarnings, EachHasItsCause) {
  Fit fit = good_fit();
  fit.pretension_interval_eV_per_A2 = {-0.01, 0.05};
  EXPECT_TRUE(says(fit_warnings(fit, {.a_A = 110}), "cannot be told from none"));
  fit = good_fit();
  fit.runs_z = 4;
  EXPECT_TRUE(says(fit_warnings(fit, {.a_A = 110}), "ordered along the depth"));
  fit = good_fit();
  fit.chi2_per_dof = 3;
  EXPECT_TRUE(says(fit_warnings(fit, {.a_A = 110}), "χ² per degree of freedom is 3.00"));
  fit = good_fit();
  fit.pretension_eV_per_A2 = -0.02;
  EXPECT_TRUE(says(fit_warnings(fit, {.a_A = 110}), "negative"));
  fit = good_fit();
  fit.bias = FitBias{20, 28, 0.02, 0.01};
  EXPECT_TRUE(says(fit_warnings(fit, {.a_A = 110}), "looks good"));
  EXPECT_TRUE(says(fit_warnings(fit, {.a_A = 110}), "40.0 % too high"));
  EXPECT_TRUE(says(fit_warnings(fit, {.a_A = 110}), "pretension is read 50 % too low"));
  EXPECT_TRUE(says(fit_warnings(good_fit(), {.a_A = 110, .bending_eV = 2}), "16κ/a²"));
  EXPECT_FALSE(says(fit_warnings(good_fit(), {.a_A = 5000, .bending_eV = 1.4}), "16κ/a²"));
  fit = good_fit();
  fit.points = 5;
  EXPECT_TRUE(says(fit_warnings(fit, {.a_A = 110}), "few"));
  EXPECT_TRUE(says(fit_warnings(good_fit(), {.a_A = 1000}), "too shallow"));
  fit = good_fit();
  fit.window_A = {15, 20};
  EXPECT_TRUE(says(fit_warnings(fit, {.a_A = 110}), "extrapolated"));
  EXPECT_TRUE(says(fit_warnings(good_fit(), {.a_A = 110, .artefact_points = 2}), "artefact"));
  EXPECT_TRUE(says(fit_warnings(good_fit(), {.a_A = 110, .longest_bond_A = 1.69, .artefact_bond_A = 1.7}), "1.690"));
  EXPECT_FALSE(says(fit_warnings(good_fit(), {.a_A = 110, .longest_bond_A = 1.69, .artefact_bond_A = 1.92}), "1.690"));
  EXPECT_TRUE(says(fit_warnings(good_fit(), {.a_A = 110, .radius_error_A = 0.35}), "0.6 %"));
  EXPECT_TRUE(says(fit_warnings(good_fit(), {.a_A = 110, .tip_assumed_a_point = true}), "no tip radius"));
}

}  // namespace
