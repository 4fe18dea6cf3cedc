// From an instrument's raw segment to force and depth: every step against what was put in.
#include "compare/instruments/prepare.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compare/base/errors.hpp"
#include "compare/fitting/normal.hpp"

namespace {

using namespace validate;

constexpr double noise = 0.1, level = 7, tilt = 2e-3, contact = 400, stiffness = 2;

/// Heights from 0 to 700 Å with the contact at 400; `attraction` over the 20 Å before it.
MeasuredCurve raw(double attraction = 0, double sign_of_height = 1, double sign_of_force = 1) {
  Normal normal(3);
  MeasuredCurve curve;
  curve.file = "raw.ibw";
  curve.depth_from_height = true;
  for (int i = 0; i <= 350; ++i) {
    const double z = 2 * i, d = z - contact;
    const double sheet = d > 0 ? stiffness * d : d > -20 ? -attraction : 0;
    curve.depth_A.push_back(sign_of_height * z);
    curve.force_eV_per_A.push_back(sign_of_force * (sheet + level + tilt * d + noise * normal()));
  }
  return curve;
}

TEST(Prepare, TakesLevelAndTiltOffAndFindsTheContact) {
  MeasuredCurve curve = raw();
  prepare(curve, Baseline::tilt, {});
  const CurvePreparation& p = curve.preparation.value();
  EXPECT_NEAR(p.level_eV_per_A, level, 0.05);
  EXPECT_NEAR(p.tilt_eV_per_A2, tilt, 3e-4);
  EXPECT_NEAR(p.noise_eV_per_A, noise, 0.03);
  EXPECT_NEAR(p.contact_A, contact, 4);
  EXPECT_FALSE(p.snap_in || p.pull_off || p.height_turned || p.force_turned);
  EXPECT_NEAR(curve.force_eV_per_A.back(), stiffness * 300, 0.5);
  EXPECT_NEAR(curve.depth_A.back(), 300, 4);
  EXPECT_EQ(curve.depth_A.size(), 351u);
}

TEST(Prepare, SignsAreThoseOfPhysicsWhateverTheFiles) {
  for (const double height : {1.0, -1.0})
    for (const double force : {1.0, -1.0}) {
      MeasuredCurve curve = raw(0, height, force);
      prepare(curve, Baseline::tilt, {});
      EXPECT_NEAR(curve.force_eV_per_A.back(), stiffness * 300, 0.5) << height << force;
      EXPECT_TRUE(std::ranges::is_sorted(curve.depth_A));
      EXPECT_EQ(curve.preparation->height_turned, height < 0);
      EXPECT_EQ(curve.preparation->force_turned, force < 0);
    }
}

TEST(Prepare, ALevelKeepsTheTiltAndNoneKeepsAll) {
  MeasuredCurve curve = raw();
  prepare(curve, Baseline::level, {});
  EXPECT_EQ(curve.preparation->tilt_eV_per_A2, 0);
  EXPECT_NEAR(curve.force_eV_per_A.front(), -tilt * contact / 2, 0.3);
  curve = raw();
  prepare(curve, Baseline::none, {});
  EXPECT_NEAR(curve.force_eV_per_A.front(), level - tilt * contact, 0.4);
}

TEST(Prepare, ASnapInIsCutOffAndReported) {
  MeasuredCurve curve = raw(5);
  prepare(curve, Baseline::tilt, {});
  ASSERT_TRUE(curve.preparation->snap_in);
  EXPECT_NEAR(curve.preparation->snap_in->force_eV_per_A, 5, 0.3);
  EXPECT_NEAR(curve.preparation->snap_in->points, 10, 2);
  EXPECT_GT(std::ranges::min(curve.force_eV_per_A), -1);
  EXPECT_NEAR(curve.preparation->tilt_eV_per_A2, tilt, 3e-4);
}

// Held to 30 Å above the contact at −2 eV/Å a Å: a triangle whose work is known.
TEST(Prepare, PullOffHasItsForceAndWork) {
  MeasuredCurve curve = raw();
  WayBack back;
  for (int i = 700; i >= 0; --i) {
    const double d = i - contact;
    back.height_A.push_back(i);
    back.force_eV_per_A.push_back(level + (d >= -30 ? stiffness * d : 0));
  }
  prepare(curve, Baseline::level, back);
  ASSERT_TRUE(curve.preparation->pull_off);
  EXPECT_NEAR(curve.preparation->pull_off->force_eV_per_A, 60, 1);
  EXPECT_NEAR(curve.preparation->pull_off->work_eV, 900, 45);  // and the trapezium of the jump, 1 Å wide
}

// Ten times as many points with noise: as many as a fit needs are left, and their noise is the mean's.
TEST(Prepare, VeryManyPointsAreAveraged) {
  Normal normal(8);
  MeasuredCurve curve;
  curve.depth_from_height = true;
  for (int i = 0; i <= 7000; ++i) {
    const double z = 0.1 * i, d = z - contact;
    curve.depth_A.push_back(z);
    curve.force_eV_per_A.push_back((d > 0 ? stiffness * d : 0) + noise * normal());
    curve.sigma_eV_per_A.push_back(noise);
  }
  prepare(curve, Baseline::level, {});
  ASSERT_EQ(curve.depth_A.size(), 875u);
  EXPECT_NEAR(curve.sigma_eV_per_A.front(), noise / std::sqrt(8), 1e-9);
  double squares = 0;
  for (int i = 0; i < 400; ++i) squares += std::pow(curve.force_eV_per_A[static_cast<std::size_t>(i)], 2);
  EXPECT_NEAR(std::sqrt(squares / 400), noise / std::sqrt(8), 0.005);
  EXPECT_EQ(curve.preparation->raw_height_A.size(), 7001u);
}

TEST(Prepare, WithoutAContactItSaysSo) {
  MeasuredCurve curve = raw();
  for (std::size_t i = 0; i < curve.depth_A.size(); ++i) curve.force_eV_per_A[i] = noise * std::cos(37.0 * double(i));
  EXPECT_THROW(prepare(curve, Baseline::tilt, {}), Error);
}

TEST(Prepare, ACurveWithoutABaselineKeepsItsForces) {
  MeasuredCurve curve;
  for (int i = 0; i <= 60; ++i) {
    curve.depth_A.push_back(10 * i);
    curve.force_eV_per_A.push_back(1e-6 * std::pow(10.0 * i, 3));
  }
  const double last = curve.force_eV_per_A.back();
  prepare(curve, Baseline::none, {});
  EXPECT_EQ(curve.force_eV_per_A.back(), last);
}

}  // namespace
