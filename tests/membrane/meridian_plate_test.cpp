// The round sheet with bending, from plate to membrane.
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "round_sheet.hpp"

namespace membrane::meridian {
namespace {

using namespace testing;
using std::numbers::pi;

// Clamped plate, small deflection: 16 π κ δ/a² under a point, and under a disc
// δ = F (4 a² − 4 c² ln(a/c) − 3 c²)/(64 π κ) (Timoshenko & Woinowsky-Krieger, Theory of Plates and Shells,
// art. 19).
TEST(MeridianPlate, SmallDeflections) {
  const double kappa = 0.966;
  const Step point = run(plate_problem(PointLoad{}, {1e-4}))[0];
  EXPECT_NEAR(point.force_eV_per_A / (16 * pi * kappa * 1e-4 / (a * a)), 1, 1e-5);
  EXPECT_NEAR(point.bending_energy_eV / point.energy_eV, 1, 1e-5);
  for (double c : {3.0, 10.0, 55.0, a}) {
    const Step disc = run(plate_problem(DiscLoad{c}, {1e-4}))[0];
    const double exact =
        disc.force_eV_per_A * (4 * a * a - 4 * c * c * std::log(a / c) - 3 * c * c) / (64 * pi * kappa);
    EXPECT_NEAR(disc.depth_A / exact, 1, 2e-6) << c;
  }
  Problem bulge = plate_problem(PressureLoad{}, {1e-12});
  const Step pressed = run(bulge)[0];
  EXPECT_NEAR(pressed.depth_A / (1e-12 * std::pow(a, 4) / (64 * kappa)), 1, 1e-6);
}

TEST(MeridianPlate, ConvergesAndNeedsFewFactorisations) {
  std::vector<double> depths;
  for (int i = 1; i <= 15; ++i) depths.push_back(2 * i);
  Problem problem = plate_problem(DiscLoad{10}, depths);
  Report report;
  const auto coarse = run(problem, &report);
  EXPECT_LE(report.factorisations, 60);
  EXPECT_LE(report.elements, 60);
  refine(problem, 4);
  const auto fine = run(problem);
  for (std::size_t i = 0; i < fine.size(); ++i)
    EXPECT_NEAR(coarse[i].force_eV_per_A / fine[i].force_eV_per_A, 1, 1e-5) << depths[i];
  // Fourth order: the error falls by 16 where elements are half as long.
  const auto error = [&](double refinement) {
    refine(problem, refinement);
    problem.levels = {10};
    const double force = run(problem)[0].force_eV_per_A;
    refine(problem, 8);
    return std::abs(force - run(problem)[0].force_eV_per_A);
  };
  EXPECT_GT(error(1) / error(2), 10);
}

// Clamped von Kármán plate, nu = 0.19, disc of a/11: depth/a at D = κ/(E·h a²), F/(E·h a) and N0/E·h, by
// collocation of its four first-order equations, computed separately. Small slopes: everything scaled down, w
// by 100.
TEST(MeridianPlate, VonKarmanFromPlateToMembrane) {
  struct Case {
    double bending, force, pretension, depth;
  };
  const double scale = 0.01;
  for (const auto& [bending, force, pretension, depth] : {Case{1e-3, 1e-3, 0, 0.01910502892},
                                                          {1e-4, 1e-4, 0, 0.01735716055},
                                                          {1e-4, 1e-2, 0, 0.1802610699},
                                                          {1e-5, 1e-4, 0, 0.03655454998},
                                                          {1e-5, 1e-2, 0, 0.1918946091},
                                                          {1e-6, 1e-4, 0, 0.0409292893},
                                                          {1e-6, 1e-2, 0, 0.1940357302},
                                                          {1e-5, 1e-4, 1e-3, 0.02375885916}}) {
    Problem problem = plate_problem(DiscLoad{a / 11}, {force * modulus * a * std::pow(scale, 3)});
    problem.law = StVenantKirchhoff{modulus, 0.19};
    problem.bending = clamped_all_round_if_any(bending * modulus * a * a * scale * scale);
    problem.prestress_eV_per_A2 = pretension * modulus * scale * scale * Eigen::Matrix2d::Identity();
    problem.control = Control::force;
    EXPECT_NEAR(run(problem)[0].depth_A / (a * scale * depth), 1, 1e-6) << bending << ", " << force;
  }
}

// Deep under the load bending no longer matters: the plate's force comes down to the membrane's.
TEST(MeridianPlate, GoesOverIntoTheMembrane) {
  Problem plate = plate_problem(DiscLoad{10}, {0.5, 5, 30});
  const auto stiff = run(plate);
  plate.bending.reset();
  const auto soft = run(plate);
  std::vector<double> excess;
  for (std::size_t i = 0; i < stiff.size(); ++i) excess.push_back(stiff[i].force_eV_per_A / soft[i].force_eV_per_A - 1);
  EXPECT_GT(excess[0], 1);
  EXPECT_GT(excess[1], 0.1);
  EXPECT_LT(excess[2], 0.03);
  EXPECT_GT(excess[2], 0);
}

}  // namespace
}  // namespace membrane::meridian
