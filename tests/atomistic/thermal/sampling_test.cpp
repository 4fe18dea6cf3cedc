#include "atomistic/thermal/sampling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "tests/atomistic/support/paths.hpp"

namespace {

using namespace atomistic;

/// The smallest sheet, pressed by a dead force.
struct Pressed {
  Problem problem = problem_of("tersoff", 8, PointLoad{}, {0.5, 1});
  Step step;

  Pressed() {
    problem.control = Control::force;
    step = follow(problem).steps.back();
  }
  Sampled sample(const Sampling& sampling, const std::optional<Sampled>& kept = {}) const {
    return sample_level(problem, step, sampling, "none", kept, [](const Sampled&) {});
  }
};

/// What is kept after a stretch is all that the next one needs: the same numbers to the last digit.
TEST(Sampling, ResumedEndsWhereTheWholeDoes) {
  const Pressed pressed;
  const Sampled whole = pressed.sample({.temperature_K = 300, .length_ps = 3});
  const Sampled part = pressed.sample({.temperature_K = 300, .length_ps = 1});
  const Sampled resumed = pressed.sample({.temperature_K = 300, .length_ps = 3}, part);
  ASSERT_EQ(whole.depths_A.size(), 300u);
  EXPECT_EQ(whole.depths_A, resumed.depths_A);
  const Sampled other = pressed.sample({.temperature_K = 300, .length_ps = 1, .seed = 2});
  EXPECT_NE(other.depths_A, part.depths_A);
}

/// The depth's variance is kT times its compliance, and the mean is known to the error asked for before the end.
TEST(Sampling, TheDepthVibratesByItsCompliance) {
  const Pressed pressed;
  Problem stiffer = pressed.problem;
  stiffer.levels = {0.98, 1.02};
  const Path near = follow(stiffer);
  const double compliance = (near.steps[1].conjugate_depth_A - near.steps[0].conjugate_depth_A) / 0.04;
  const Sampled sampled = pressed.sample({.temperature_K = 100, .length_ps = 200, .relative_error = 0.01});
  EXPECT_LT(sampled.length_ps, 200);
  EXPECT_LE(sampled.error_A, 0.01 * sampled.mean_depth_A);
  EXPECT_NEAR(sampled.mean_depth_A, pressed.step.conjugate_depth_A, 0.04 * sampled.mean_depth_A);
  double variance = 0;
  for (const double depth : sampled.depths_A)
    variance += std::pow(depth - sampled.mean_depth_A, 2) / static_cast<double>(sampled.depths_A.size());
  EXPECT_NEAR(variance / (8.617333e-5 * 100 * compliance), 1, 0.5);
}

}  // namespace
