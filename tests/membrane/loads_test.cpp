// Spheres, moving edges and combinations, by solve(), against solvers written separately.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "compare/verify/reference_numbers.hpp"
#include "membrane/triangles/fields.hpp"
#include "solved_path.hpp"

namespace membrane {
namespace {

double number(const char* name) { return reference::number(name).value; }
using std::numbers::pi;
using testing::disc_problem;
using testing::solved_path;

constexpr double N_per_m = 16.02176634;  // one eV/Å²

Problem disc(double modulus, double nu, double radius, Load load, Control control, std::vector<double> levels) {
  Problem problem = disc_problem(modulus, nu, std::move(load), std::move(levels), radius);
  problem.control = control;
  return problem;
}

Problem figure1_sphere(std::vector<double> levels) {
  Problem problem = disc(342 / N_per_m, 0.165, 5000, SphereLoad{165}, Control::conjugate_depth, std::move(levels));
  problem.prestress_eV_per_A2 = 0.34 / N_per_m * Eigen::Matrix2d::Identity();
  return problem;
}

TEST(Sphere, ForceAndBalance) {
  const double nN = 1.602176634;
  const double forces[] = {number("sphere_16.5_nm.force_at_20_nm"), number("sphere_16.5_nm.force_at_50_nm"),
                           number("sphere_16.5_nm.force_at_100_nm")};
  for (const Step& step : solved_path(figure1_sphere({200, 500, 1000}))) {
    EXPECT_NEAR(step.force_eV_per_A * nN / forces[step.level], 1, 1.5e-3) << step.conjugate_depth_A;
    EXPECT_NEAR(step.support_force_eV_per_A.z() / step.force_eV_per_A, 1, 1e-7);
    EXPECT_LE(step.penetration_A, 1e-6 * 165);
  }
}

TEST(Sphere, BothControlsFindTheSameState) {
  Problem problem = figure1_sphere({500});
  const Step by_depth = solved_path(problem).at(0);
  problem.control = Control::force;
  problem.levels = {by_depth.force_eV_per_A};
  EXPECT_NEAR(solved_path(problem).at(0).conjugate_depth_A, 500, 1e-5);
}

TEST(Sphere, ForceIsTheDerivativeOfTheEnergy) {
  const auto steps = solved_path(figure1_sphere({499, 500, 501}));
  EXPECT_NEAR((steps[2].energy_eV - steps[0].energy_eV) / 2 / steps[1].force_eV_per_A, 1, 1e-5);
}

TEST(EdgeMotions, HubTorqueOfAWrinkledAnnulus) {
  for (const auto& [ratio, name] : {std::pair{1.5, "annulus_torque.b_1.5a"}, {2.0, "annulus_torque.b_2a"}}) {
    const auto torque = [&, ratio = ratio](int rings) {
      Problem problem;
      problem.sheet = AnnulusSheet{.hub_radius_A = 50, .radius_A = 50 * ratio, .rings = rings, .around = 8 * rings};
      problem.law = StVenantKirchhoff{8, 0};
      problem.load = EdgeMotion{.edge = Edge::hub, .rotation_rad = 1};
      problem.levels = {1e-4};
      const Step step = solved_path(problem).at(0);
      EXPECT_LE(step.edge_force_eV_per_A.norm() * 50, 1e-9 * std::abs(step.edge_torque_eV));
      const SheetFields fields = fields_of(problem, mesh_of(problem), step.on_triangles().displacements);
      EXPECT_GT(fields.wrinkled_area_fraction, 0.999);
      return step.edge_torque_eV / (8 * 1e-4 * 50 * 50);
    };
    // Too stiff by the square of the mesh: extrapolate.
    const double coarse = torque(15), fine = torque(30);
    EXPECT_NEAR((4 * fine - coarse) / 3 / number(name), 1, 1e-3) << ratio;
    EXPECT_NEAR(fine / number(name), 1, 4e-3) << ratio;
  }
}

TEST(EdgeMotions, StretchedStripFollowsHooke) {
  // Both ends clamped, long strip: uniaxial in the middle: N = E·h E11 there by the relaxed law.
  Problem problem;
  problem.sheet = RectangleSheet{.length_x_A = 400,
                                 .length_y_A = 40,
                                 .cells_x = 80,
                                 .cells_y = 8,
                                 .extent = Extent::full,
                                 .left = Support::clamped,
                                 .right = Support::clamped,
                                 .bottom = Support::free,
                                 .top = Support::free};
  problem.law = StVenantKirchhoff{8, 0.3};
  problem.load = EdgeMotion{.edge = Edge::right, .translation_A = {1, 0, 0}};
  problem.levels = {4};
  const Step step = solved_path(problem).at(0);
  const SheetFields fields = fields_of(problem, mesh_of(problem), step.on_triangles().displacements);
  const std::size_t middle = 2 * (4 * 80 + 40);  // two triangles a cell, rows of 80
  const double stretch = std::sqrt(1 + 2 * fields.strain[middle][0]);
  EXPECT_NEAR(step.edge_force_eV_per_A.x() / (40 * stretch * 8 * fields.strain[middle][0]), 1, 2e-3);
  // Wrinkles may hide any width beyond the natural one.
  EXPECT_LE(fields.strain[middle][1] / fields.strain[middle][0], -0.3 + 3e-3);
}

TEST(Square, SlidingEdgesWrinkleAndNothingIsCompressed) {
  // Figure 4 on a coarse quarter: centre depth 56.31 Å on 60 cells (computed with a code written separately).
  Problem problem = disc(5.864 * 1.37, 0.19, 1, PressureLoad{}, Control::force, {5.16529e-4});
  RectangleSheet square = paper_square(220);
  square.extent = Extent::quarter;
  square.cells_x = square.cells_y = 20;
  problem.sheet = square;
  const Step step = solved_path(problem).at(0);
  EXPECT_NEAR(step.depth_A, 56.31, 0.1);
  const Mesh mesh = mesh_of(problem);
  const SheetFields fields = fields_of(problem, mesh, step.on_triangles().displacements);
  EXPECT_GT(fields.wrinkled_area_fraction + fields.slack_area_fraction, 0.5);
  EXPECT_LT(fields.wrinkled_area_fraction, 0.75);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    EXPECT_GE(fields.force_2_eV_per_A2[t], -1e-12);
    EXPECT_GE(fields.cauchy_2_eV_per_A2[t], -1e-12);
  }
  for (int n = 0; n < mesh.node_count(); ++n)
    for (int c : {0, 1}) EXPECT_GE(mesh.nodes[n][c] + step.on_triangles().displacements[3 * n + c], -1e-4);
}

TEST(Combined, IndentingABulge) {
  for (Load load : {Load{DiscLoad{11}}, Load{SphereLoad{30}}}) {
    Problem problem = disc(8.03368, 0.19, 110, load, Control::conjugate_depth, {0, 5, 10});
    std::get<DiscSheet>(problem.sheet).rings = 32;
    problem.pressure_eV_per_A3 = -1e-4;  // up, against the tip
    const auto steps = solved_path(problem);
    for (const Step& step : steps) {
      EXPECT_EQ(step.pressure_eV_per_A3, -1e-4);
      // What the pressure lifts and the tip does not push down, the rim holds down.
      const double lifted = 1e-4 * 4 * mesh_of(problem).area_A2();
      EXPECT_NEAR((step.force_eV_per_A - lifted) / step.support_force_eV_per_A.z(), 1, 1e-5);
    }
    EXPECT_GT(steps[0].force_eV_per_A, 0.5);  // it takes a force to press a bulge flat
    // Energy of sheet and gas: d(U + p V)/dd = F. Trapezoid over 5 Å with a force that is nearly linear.
    const auto total = [&](const Step& s) { return s.energy_eV - s.pressure_eV_per_A3 * s.volume_A3; };
    const double mean_force = (steps[1].force_eV_per_A + steps[2].force_eV_per_A) / 2;
    EXPECT_NEAR((total(steps[2]) - total(steps[1])) / 5 / mean_force, 1, 2e-2);
  }
}

TEST(Radial, ConeOfDensityIsAPatternToo) {
  // N0 w' r = −F_enclosed / 2π with density 1 − r/c: w(0) = (F / 2πN0)(ln(a/c) + 5/6).
  Problem problem = disc(8, 0.19, 110, RadialLoad{{0, 20}, {1, 0}}, Control::force, {1e-3});
  problem.prestress_eV_per_A2 = Eigen::Matrix2d::Identity();
  const Step step = solved_path(problem).at(0);
  EXPECT_NEAR(step.depth_A / (1e-3 / (2 * pi) * (std::log(5.5) + 5.0 / 6)), 1, 1e-3);
}

TEST(Sheets, PaperMeshes) {
  EXPECT_EQ(make_mesh(paper_disc(110)).triangles.size(), 1936u);
  EXPECT_EQ(make_mesh(paper_square(220)).triangles.size(), 7200u);
  EXPECT_EQ(make_mesh(DiscSheet{.radius_A = 110, .rings = 90, .extent = Extent::full}).triangles.size(), 48600u);
}

TEST(Sheets, FullAndQuarterDiscAgree) {
  Problem problem = disc(8, 0.19, 110, DiscLoad{10}, Control::conjugate_depth, {10});
  const double quarter = solved_path(problem).at(0).force_eV_per_A;
  problem.sheet = DiscSheet{.radius_A = 110, .rings = 48, .extent = Extent::full};
  EXPECT_NEAR(solved_path(problem).at(0).force_eV_per_A / quarter, 1, 2e-3);
}

}  // namespace
}  // namespace membrane
