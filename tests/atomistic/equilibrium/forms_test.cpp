// Loads and sheets beyond the main job's: sphere, pressure, squares, defects, orientation, unloading.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/atomistic/support/paths.hpp"

namespace {

using namespace atomistic;

double mean_evaluations(const Path& path) {
  double sum = 0;
  for (std::size_t i = 1; i < path.steps.size(); ++i) sum += path.steps[i].evaluations;
  return sum / static_cast<double>(path.steps.size() - 1);
}

void expect_converged(const Path& path, std::size_t steps) {
  ASSERT_EQ(path.steps.size(), steps) << path.report.reason;
  for (const Step& step : path.steps) {
    EXPECT_TRUE(step.converged);
    EXPECT_LE(step.max_force_eV_per_A, 1e-5);
  }
}

/// Work of force over conjugate depth between the first and the last of an even number of equal steps, by Simpson.
double simpson(const std::vector<Step>& steps) {
  double work = 0;
  for (std::size_t k = 2; k < steps.size(); k += 2) {
    const double h = (steps[k].conjugate_depth_A - steps[k - 2].conjugate_depth_A) / 6;
    work += h * (steps[k - 2].force_eV_per_A + 4 * steps[k - 1].force_eV_per_A + steps[k].force_eV_per_A);
  }
  return work;
}

TEST(Sphere, EnergyIsTheWorkOfItsForce) {
  std::vector<double> depths;
  for (int k = 2; k <= 10; ++k) depths.push_back(0.25 * k);
  const Path path = follow(problem_of("tersoff", 20, SphereLoad{.radius_A = 8}, depths));
  expect_converged(path, depths.size());
  const double work = simpson(path.steps);
  EXPECT_NEAR(path.steps.back().energy_eV - path.steps.front().energy_eV, work, 2e-3 * work);
}

TEST(Sphere, HeldForceAndHeldDepthAreOneCurve) {
  const Path depth = follow(problem_of("tersoff", 20, SphereLoad{.radius_A = 8}, {1, 2, 3}));
  Problem p = problem_of("tersoff", 20, SphereLoad{.radius_A = 8}, {});
  p.control = Control::force;
  for (const Step& step : depth.steps) p.levels.push_back(step.force_eV_per_A);
  const Path force = follow(p);
  expect_converged(force, 3);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(force.steps[i].conjugate_depth_A, depth.steps[i].conjugate_depth_A, 1e-4);
}

/// A softer contact lets the atoms in; at equal depth of the sheet the force hardly notices.
TEST(Sphere, ReportsWhatItsStiffnessDoes) {
  const Path path = follow(problem_of("tersoff", 30, SphereLoad{.radius_A = 8}, {2, 3, 4}));
  ASSERT_TRUE(path.report.contact.has_value());
  const ContactCheck& check = *path.report.contact;
  EXPECT_GT(check.deepest_penetration_A, 0);
  EXPECT_LT(check.deepest_penetration_A, 0.1);
  EXPECT_GT(check.force_change_relative, 0);
  EXPECT_LT(std::abs(check.force_change_at_equal_depth_relative), 3e-3);
}

/// Held forces may come in any order, and twice.
TEST(Indentation, ALevelMayComeAgain) {
  Problem p = problem_of("tersoff", 20, DiscLoad{6}, {1, 2, 1, 3});
  p.control = Control::force;
  const Path path = follow(p);
  expect_converged(path, 4);
  EXPECT_NEAR(path.steps[2].depth_A, path.steps[0].depth_A, 1e-4);
}

TEST(Pressure, EnergyIsPressureOverVolume) {
  std::vector<double> pressures;
  Problem p = problem_of("tersoff", 20, PressureLoad{}, {});
  p.control = Control::force;
  for (int k = 1; k <= 9; ++k) p.levels.push_back(1e-3 * k);
  const Path path = follow(p);
  expect_converged(path, 9);
  double work = 0;  // ∫ V dp by Simpson on equal pressures, then by parts
  const auto& s = path.steps;
  for (std::size_t k = 2; k < 9; k += 2)
    work -= (s[k].force_eV_per_A - s[k - 2].force_eV_per_A) / 6 *
            (s[k - 2].conjugate_depth_A + 4 * s[k - 1].conjugate_depth_A + s[k].conjugate_depth_A);
  work += s[8].force_eV_per_A * s[8].conjugate_depth_A - s[0].force_eV_per_A * s[0].conjugate_depth_A;
  EXPECT_NEAR(s[8].energy_eV - s[0].energy_eV, work, 1e-3 * work);
  for (const Step& step : s) EXPECT_LT(step.balance_relative, 1e-3);
}

/// A dead pressure keeps its direction: the same at small deflection, and softer by order (depth/R)² beyond, since a
/// following one also pulls outward on the inflated sheet.
TEST(Pressure, DeadAndFollowingPartWithTheDepth) {
  double gap[2];
  int k = 0;
  for (double pressure : {5e-4, 8e-3}) {
    Problem following = problem_of("tersoff", 20, PressureLoad{true}, {pressure}), dead = following;
    dead.load = PressureLoad{false};
    following.control = dead.control = Control::force;
    const double with = follow(following).steps.at(0).depth_A, without = follow(dead).steps.at(0).depth_A;
    gap[k++] = std::abs(with / without - 1);
  }
  EXPECT_LT(gap[0], 0.01);
  EXPECT_GT(gap[1], 3 * gap[0]);
  EXPECT_LT(gap[1], 0.1);
}

/// Hencky's clamped membrane, w0 = C(ν) a (p a/E·h)^{1/3}: bending and the small size keep the atoms below it.
TEST(Pressure, AtomsApproachHencky) {
  Problem p = problem_of("tersoff", 50, PressureLoad{}, {1e-3, 4e-3});
  p.control = Control::force;
  const Path path = follow(p);
  expect_converged(path, 2);
  const double a = 50 + 0.75 * make_sheet(p).bond_A, Eh = p.card.sheet_modulus_eV_per_A2();
  const double C =
      0.679687 + (0.19 - p.card.nu()) * (0.679687 - 0.653443) / (0.19 - 0.3) * -1;  // between ν = 0.19 and 0.3
  double ratio[2];
  for (int i : {0, 1}) ratio[i] = path.steps[i].depth_A / (C * a * std::cbrt(p.levels[i] * a / Eh));
  EXPECT_NEAR(ratio[1], 1, 0.06);
  EXPECT_LT(ratio[0], ratio[1]);
}

Problem square(Edge edge) {
  Problem p = problem_of("rebo", 25, PressureLoad{}, {1e-3, 2e-3, 3e-3});
  p.control = Control::force;
  p.form.shape = Shape::square;
  p.form.edge = edge;
  return p;
}

TEST(Square, SlidingEdgesStayInThePlaneAndComeIn) {
  const Problem p = square(Edge::sliding);
  const Path path = follow(p);
  expect_converged(path, 3);
  EXPECT_GT(path.report.relaxation_evaluations, 1);
  const Sheet sheet = make_sheet(p);
  double in = 0, before = 0;
  for (int i = 0; i < sheet.free_atoms; ++i) {
    if (!sheet.slides[i]) continue;
    EXPECT_EQ(path.steps.back().positions[3 * i + 2], 0);
    before += sheet.position(i).head<2>().norm();
    in += path.steps.back().positions.segment<2>(3 * i).norm();
  }
  EXPECT_LT(in, before);
  EXPECT_LT(path.steps.back().balance_relative, 1e-3);
}

TEST(Square, ClampedIsStifferThanSliding) {
  const Path clamped = follow(square(Edge::clamped)), sliding = follow(square(Edge::sliding));
  expect_converged(clamped, 3);
  EXPECT_LT(clamped.steps[2].depth_A, sliding.steps[2].depth_A);
  EXPECT_EQ(clamped.report.relaxation_evaluations, 0);
}

/// A taut sheet has one equilibrium: wherever the search starts it ends there.
TEST(Ripple, DoesNotMoveTheEquilibriumOfATautSheet) {
  Problem p = problem_of("tersoff", 20, PressureLoad{}, {4e-3, 4e-3});
  p.control = Control::force;
  const Step still = follow(p).steps.at(0);
  p.ripple_A = 0.3;
  p.ripple_seed = 7;
  p.virials = true;
  const Path path = follow(p);
  expect_converged(path, 2);
  for (const Step& step : path.steps) {
    EXPECT_GT(step.evaluations, 5);  // the second level too starts away from where the first ended
    EXPECT_NEAR(step.depth_A, still.depth_A, 1e-4);
    EXPECT_EQ(step.virials.size(), 2 * step.positions.size());
  }
}

class DefectOf : public testing::TestWithParam<std::string> {};

/// The preconditioner copes with missing and turned bonds, whose own stiffness it does not know and which L-BFGS learns
/// anew at each depth: three to four times the evaluations of a perfect sheet. What they do to the force is small at
/// this distance.
TEST_P(DefectOf, CostsFewEvaluations) {
  const std::vector<double> depths = {0.6, 1.2, 1.8, 2.4, 3};
  const Problem perfect = problem_of(GetParam(), 30, DiscLoad{5}, depths);
  const Path whole = follow(perfect);
  Problem vacancies = perfect, turned = perfect;
  vacancies.form.vacancies = {{10, 3}, {-12, 5}};
  turned.form.stone_wales = {{11, 1}, {-3, -14}};
  for (const Problem& p : {vacancies, turned}) {
    const Path path = follow(p);
    expect_converged(path, depths.size());
    EXPECT_LE(mean_evaluations(path), 30);
    EXPECT_LE(path.report.relaxation_evaluations, 40);
    const double ratio = path.steps.back().force_eV_per_A / whole.steps.back().force_eV_per_A;
    EXPECT_GT(ratio, 0.8);
    EXPECT_LT(ratio, 1.05);
  }
}

INSTANTIATE_TEST_SUITE_P(Some, DefectOf, testing::Values("tersoff", "rebo"), test_name);

/// The lattice's orientation and the place of the axis are details of a disc's edge and tip: per cent, not more.
TEST(Orientation, HardlyMattersForADisc) {
  const std::vector<double> depths = {2, 3};
  const Problem hexagon = problem_of("tersoff", 30, DiscLoad{8}, depths);
  Problem turned = hexagon, atom = hexagon;
  turned.form.rotation_deg = 15;
  atom.form.centre = Centre::atom;
  const double force = follow(hexagon).steps.back().force_eV_per_A;
  EXPECT_NEAR(follow(turned).steps.back().force_eV_per_A, force, 0.05 * force);
  EXPECT_NEAR(follow(atom).steps.back().force_eV_per_A, force, 0.05 * force);
}

TEST(Orientation, SixtyDegreesAreNone) {
  Problem p = problem_of("tersoff", 20, DiscLoad{6}, {2});
  const Step straight = follow(p).steps[0];
  p.form.rotation_deg = 60;
  const Step turned = follow(p).steps[0];
  EXPECT_NEAR(turned.force_eV_per_A, straight.force_eV_per_A, 1e-7 * straight.force_eV_per_A);
}

/// Without a broken bond the way back is the way there.
TEST(Unloading, IsReversibleAndKnowsItsPlace) {
  Problem p = problem_of("rebo", 20, DiscLoad{6}, {1, 2, 3});
  p.unload = true;
  const Path whole = follow(p);
  expect_converged(whole, 5);
  for (std::size_t back : {3u, 4u}) {
    const Step &down = whole.steps[back], &up = whole.steps[4 - back];
    EXPECT_TRUE(down.unloading);
    EXPECT_EQ(down.target, up.target);
    EXPECT_NEAR(down.force_eV_per_A, up.force_eV_per_A, 1e-5 * up.force_eV_per_A);
  }
  for (std::size_t kept = 1; kept < 5; ++kept) {
    const Path rest = follow(p, {whole.steps.begin(), whole.steps.begin() + static_cast<long>(kept)});
    ASSERT_EQ(rest.steps.size(), 5 - kept);
    EXPECT_NEAR(rest.steps.back().force_eV_per_A, whole.steps.back().force_eV_per_A,
                1e-8 * whole.steps.back().force_eV_per_A);
  }
}

TEST(Unloading, GoesBackFromTheArtefactZone) {
  Problem p = problem_of("rebo", 20, PointLoad{}, {2, 4, 5, 6, 7, 8});
  p.unload = true;
  const Path path = follow(p);
  EXPECT_EQ(path.report.ended, Ended::artefact) << path.report.reason;
  EXPECT_TRUE(path.steps.back().unloading);
  EXPECT_EQ(path.steps.back().target, 2);
}

/// All that a later step uses is in the steps: a resumed sphere, and a resumed sheet with defects, end the same.
TEST(Resume, SphereAndDefects) {
  Problem sphere = problem_of("rebo", 20, SphereLoad{.radius_A = 8}, {1, 1.5, 2, 2.5});
  Problem defects = problem_of("rebo", 20, DiscLoad{6}, {1, 1.5, 2, 2.5});
  defects.form.vacancies = {{9, 3}};
  for (const Problem& p : {sphere, defects}) {
    const Path whole = follow(p), rest = follow(p, {whole.steps.begin(), whole.steps.begin() + 2});
    ASSERT_EQ(rest.steps.size(), 2u);
    for (int i : {0, 1}) {
      const Step &a = whole.steps[2 + i], &b = rest.steps[i];
      EXPECT_NEAR(b.force_eV_per_A, a.force_eV_per_A, 1e-8 * a.force_eV_per_A);
      EXPECT_EQ(b.evaluations, a.evaluations);
    }
  }
}

}  // namespace
