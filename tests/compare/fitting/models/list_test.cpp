// Every closed form: its gradient, what it says of itself, and the limits it must have.
#include "compare/fitting/models/list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/base/errors.hpp"

using namespace validate;

namespace {

const ModelGeometry geometry{.a_A = 5000, .nu = 0.165, .tip_A = 165, .bending_eV = 1.4};

class Models : public testing::TestWithParam<std::size_t> {
 protected:
  const ClosedForm& form() const { return closed_forms()[GetParam()]; }
};

TEST_P(Models, GradientIsTheValuesDerivative) {
  const AnyCurveModel model = form().make(geometry);
  ASSERT_EQ(model.parameter_count, 2);
  const double at[] = {21.3, 0.0212};
  for (const double depth : {20.0, 200.0, 1000.0}) {
    double gradient[2];
    model.gradient(depth, at, gradient);
    for (int i = 0; i < 2; ++i) {
      double up[] = {at[0], at[1]}, down[] = {at[0], at[1]};
      const double h = 1e-4 * at[i];
      up[i] += h;
      down[i] -= h;
      const double difference = (model.value(depth, up) - model.value(depth, down)) / (2 * h);
      EXPECT_NEAR(gradient[i], difference, 1e-6 * std::abs(difference) + 1e-12) << depth << ' ' << i;
    }
  }
}

TEST_P(Models, GrowWithDepthAndBothParameters) {
  const AnyCurveModel model = form().make(geometry);
  const double soft[] = {10, 0.01}, stiff[] = {20, 0.01}, tense[] = {10, 0.02};
  for (const double depth : {50.0, 500.0}) {
    EXPECT_GT(model.value(2 * depth, soft), 2 * model.value(depth, soft));
    EXPECT_GT(model.value(depth, stiff), model.value(depth, soft));
    EXPECT_GT(model.value(depth, tense), model.value(depth, soft));
  }
}

TEST_P(Models, SayWhatTheyAre) {
  EXPECT_FALSE(form().formula.empty() || form().validity.empty() || form().source.empty());
  EXPECT_EQ(&closed_form(form().name, "--model"), &form());
}

INSTANTIATE_TEST_SUITE_P(All, Models, testing::Range<std::size_t>(0, closed_forms().size()), [](const auto& test) {
  std::string name(closed_forms()[test.param].name);
  std::ranges::replace(name, '-', '_');
  return name;
});

double value(const char* name, double depth, double Eh, double pretension) {
  const double parameters[] = {Eh, pretension};
  return closed_form(name, "").make(geometry).value(depth, parameters);
}

TEST(ModelLimits, TheFullCurveHasBothLimits) {
  EXPECT_NEAR(value("foeppl", 1000, 20, 1e-7) / value("disc", 1000, 20, 1e-7), 1, 1e-6);
  EXPECT_NEAR(value("foeppl", 1, 20, 0.02) / value("tip-pretension", 1, 20, 0.02), 1, 1e-3);
  const double between = value("foeppl", 300, 20, 0.02);
  EXPECT_LT(between, value("disc", 300, 20, 0.02));  // concave in the pretension
  EXPECT_GT(between, value("disc", 300, 20, 0));
}

TEST(ModelLimits, ASphereWhoseContactIsADiscsSizePullsAsHard) {
  // Rt chosen so that the contact radius is the disc's at this depth: F/δ = 2π N0/(ln(a/b) + ½) for both.
  const double depth = 1, b = geometry.tip_A;
  ModelGeometry sphere = geometry;
  sphere.tip_A = b * b * (std::log(geometry.a_A / b) + 0.5) / depth;
  const double parameters[] = {1e-9, 0.02};
  EXPECT_NEAR(closed_form("sphere-pretension", "").make(sphere).value(depth, parameters) /
                  value("tip-pretension", depth, 1e-9, 0.02),
              1, 1e-6);
}

TEST(ModelList, IsInOrderAndNamesTheNearest) {
  EXPECT_TRUE(std::ranges::is_sorted(closed_forms(), {}, &ClosedForm::name));
  try {
    closed_form("foepl", "--model");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_code(), ExitCode::bad_input);
    EXPECT_NE(std::string(error.what()).find("'foeppl'?"), std::string::npos) << error.what();
  }
}

}  // namespace
