#include "atomistic/equilibrium/indentation.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "atomistic/loads/load_term.hpp"
#include "tests/atomistic/support/paths.hpp"

namespace {

using namespace atomistic;
using Eigen::VectorXd;

/// AIREBO, R = 30 Å, the six central atoms held: forces of a program written separately from this project (its clamped
/// ring 12 Å wide, max|f| <= 1e-5 eV/Å), within 0.5 % from 2 Å up.
TEST(Indentation, AireboPointLoadMatchesTheReference) {
  std::ifstream file(TEST_DATA "/airebo_r30_point.csv");
  std::vector<double> depths, forces;
  for (std::string line; std::getline(file, line);) {
    std::istringstream in(line);
    double depth, force;
    char comma;
    if (in >> depth >> comma >> force) depths.push_back(depth), forces.push_back(force);
  }
  ASSERT_EQ(depths.size(), 8u);
  const Path path = follow(problem_of("airebo", 30, PointLoad{}, depths));
  ASSERT_EQ(path.steps.size(), 8u) << path.report.reason;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    if (depths[i] < 2) continue;
    EXPECT_NEAR(path.steps[i].force_eV_per_A, forces[i], 0.005 * forces[i]) << "at " << depths[i] << " Å";
    EXPECT_LE(path.steps[i].max_force_eV_per_A, 1e-5);
  }
}

class PathOf : public testing::TestWithParam<std::string> {};

/// The engine's promise: at most 12 force evaluations a depth on average, at max|f| <= 1e-5 eV/Å, for depths of the
/// main job's step.
TEST_P(PathOf, NeedsFewEvaluations) {
  for (const Load& load : {Load(PointLoad{}), Load(DiscLoad{10})}) {
    const Path path = follow(problem_of(GetParam(), 30, load, {2, 4, 6, 6.6}));
    double evaluations = 0, depths = 0;
    for (const Step& step : path.steps) {
      EXPECT_TRUE(step.converged);
      EXPECT_LE(step.max_force_eV_per_A, 1e-5);
      if (step.longest_bond_A < 1.68) evaluations += step.evaluations, ++depths;
    }
    ASSERT_GE(depths, 3);
    EXPECT_LE(evaluations / depths, 12);
  }
}

/// Two independent measurements of the work: the energy of the sheet, and force over conjugate depth. F(d) is
/// integrated with the rule of third order (three points) on two fine steps, where its error is far below 0.1 %.
TEST_P(PathOf, EnergyIsTheWorkOfTheForce) {
  std::vector<double> depths;
  for (int i = 1; i <= 8; ++i) depths.push_back(0.5 * i);
  const Path path = follow(problem_of(GetParam(), 20, DiscLoad{6}, depths));
  ASSERT_EQ(path.steps.size(), 8u);
  for (std::size_t i = 3; i < 8; i += 2) {
    const Step &a = path.steps[i - 2], &b = path.steps[i - 1], &c = path.steps[i];
    const double work = (a.force_eV_per_A + 4 * b.force_eV_per_A + c.force_eV_per_A) * 0.5 / 3;  // Simpson
    EXPECT_NEAR(c.energy_eV - a.energy_eV, work, 1e-3 * work) << "to " << c.conjugate_depth_A << " Å";
  }
}

TEST_P(PathOf, TheRimCarriesTheForce) {
  Problem p = problem_of(GetParam(), 20, DiscLoad{6}, {2});
  EXPECT_LT(follow(p).steps[0].balance_relative, 1e-3);
  p.force_tolerance_eV_per_A = 1e-7;
  EXPECT_LT(follow(p).steps[0].balance_relative, 1e-5);
}

/// Over a whole path in the main job's steps: E(d) against the integral of the cubic through four neighbouring points
/// (the origin is one), from the second depth on.
TEST(Indentation, EnergyIsTheIntegralOverTheConjugateDepth) {
  const double radius = 30;
  std::vector<double> depths;
  for (int k = 1; k <= 10; ++k) depths.push_back(k * radius / 55);
  const Path path = follow(problem_of("airebo", radius, DiscLoad{4}, depths));
  ASSERT_EQ(path.steps.size(), depths.size());
  std::vector<double> d = {0}, f = {0};
  for (const Step& step : path.steps) d.push_back(step.conjugate_depth_A), f.push_back(step.force_eV_per_A);
  const auto cubic = [&](std::size_t first, double x) {
    double sum = 0;
    for (std::size_t i = first; i < first + 4; ++i) {
      double weight = f[i];
      for (std::size_t j = first; j < first + 4; ++j)
        if (j != i) weight *= (x - d[j]) / (d[i] - d[j]);
      sum += weight;
    }
    return sum;
  };
  double work = 0;
  for (std::size_t k = 1; k < d.size(); ++k) {
    const std::size_t first = std::min(k < 2 ? 0 : k - 2, d.size() - 4);
    const double h = d[k] - d[k - 1], middle = (d[k] + d[k - 1]) / 2;  // Simpson is exact for the cubic
    work += h / 6 * (f[k - 1] + 4 * cubic(first, middle) + f[k]);
    if (k > 1) {
      EXPECT_NEAR(path.steps[k - 1].energy_eV, work, 1e-3 * work) << "at " << d[k] << " Å";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, PathOf, testing::ValuesIn(shipped_potentials()), test_name);

TEST(Indentation, DeadForceAndControlledDepthAreOneCurve) {
  const Path depth = follow(problem_of("tersoff", 20, DiscLoad{6}, {1, 2, 3}));
  Problem p = problem_of("tersoff", 20, DiscLoad{6}, {});
  p.control = Control::force;
  for (const Step& step : depth.steps) p.levels.push_back(step.force_eV_per_A);
  const Path force = follow(p);
  ASSERT_EQ(force.steps.size(), 3u) << force.report.reason;
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(force.steps[i].conjugate_depth_A, depth.steps[i].conjugate_depth_A, 1e-4);
}

/// Pretension: under a small disc load the stretched sheet answers with F/d = 2πN0/(ln(a/c) + ¼), the log law of a
/// taut membrane in the conjugate depth, far above the unstretched sheet's bending.
TEST(Indentation, ImposedStrainActsAsPretension) {
  Problem p = problem_of("tersoff", 30, DiscLoad{8}, {0.05});
  p.biaxial_strain = 0.01;
  const Step step = follow(p).steps[0];
  const Sheet sheet = make_sheet(p);
  const double N0 = p.card.sheet_modulus_eV_per_A2() / (1 - p.card.nu()) * 0.01 *
                    (1 - p.card.bond_softening * 0.01 / 2);  // with the bonds' softening
  const double a = 30 + 0.75 * sheet.bond_A, area = 0.75 * std::numbers::sqrt3 * sheet.bond_A * sheet.bond_A;
  const double c = std::sqrt(loaded_atoms(p.load, sheet).size() * area / std::numbers::pi);
  const double taut = 2 * std::numbers::pi * N0 / (std::log(a / c) + 0.25);
  const double ratio = step.force_eV_per_A / step.conjugate_depth_A / taut;
  EXPECT_GT(ratio, 1.0);   // bending adds
  EXPECT_LT(ratio, 1.25);  // and shortens the radius by about √(κ/N0) = 2.5 Å
}

TEST(Indentation, KeepsTheSixfoldSymmetry) {
  const Path path = follow(problem_of("airebo", 20, DiscLoad{6}, {2, 4}));
  const Step& step = path.steps.back();
  const Sheet sheet = make_sheet(problem_of("airebo", 20, DiscLoad{6}, {2}));
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(std::numbers::pi / 3, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  for (int i = 0; i < sheet.free_atoms; i += 5) {
    const Eigen::Vector3d image = turn * step.positions.segment<3>(3 * i);
    double nearest = 1;
    for (int j = 0; j < sheet.free_atoms; ++j)
      nearest = std::min(nearest, (step.positions.segment<3>(3 * j) - image).norm());
    EXPECT_LT(nearest, 2e-4);
  }
}

TEST(Indentation, ResumedAndUninterruptedPathsAreTheSame) {
  const Problem p = problem_of("rebo", 20, DiscLoad{6}, {1, 2, 3, 4, 5});
  const Path whole = follow(p);
  for (std::size_t kept : {1u, 3u}) {
    const Path rest = follow(p, {whole.steps.begin(), whole.steps.begin() + static_cast<long>(kept)});
    ASSERT_EQ(rest.steps.size(), 5 - kept);
    for (std::size_t i = kept; i < 5; ++i) {
      const Step &a = whole.steps[i], &b = rest.steps[i - kept];
      EXPECT_EQ(a.evaluations, b.evaluations);
      EXPECT_NEAR(a.force_eV_per_A, b.force_eV_per_A, 1e-8 * a.force_eV_per_A);
      EXPECT_NEAR(a.energy_eV, b.energy_eV, 1e-8 * a.energy_eV);
    }
  }
}

TEST(Indentation, EndsAtTheArtefactBondAndKeepsThatDepth) {
  Problem p = problem_of("rebo", 20, PointLoad{}, {2, 4, 5, 6, 7, 8});
  const Path path = follow(p);
  ASSERT_EQ(path.report.ended, Ended::artefact) << path.report.reason;
  EXPECT_GE(path.steps.back().longest_bond_A, 1.70);
  for (std::size_t i = 0; i + 1 < path.steps.size(); ++i) EXPECT_LT(path.steps[i].longest_bond_A, 1.70);
  p.past_artefact = true;
  EXPECT_GT(follow(p).steps.size(), path.steps.size());
}

/// Torn by whatever load: an end of the path, not a failure of the solver or of LAMMPS, and found without chasing the
/// fragments.
TEST(Indentation, TearingTheSheetIsRupture) {
  Problem p = problem_of("tersoff", 15, DiscLoad{5}, {2, 4, 6, 8, 10, 12, 14});
  p.past_artefact = true;
  Problem pulled_off = problem_of("tersoff", 15, PointLoad{}, {1000});
  pulled_off.control = Control::force;
  for (const Problem& problem : {p, pulled_off}) {
    const Path path = follow(problem);
    EXPECT_EQ(path.report.ended, Ended::rupture) << path.report.reason;
    const auto broken = std::ranges::find_if(path.steps, [](const Step& s) { return s.broken; });
    ASSERT_NE(broken, path.steps.end());
    EXPECT_GE(broken->longest_bond_A, 2.0);
    EXPECT_LT(broken->evaluations, 200);
  }
}

/// A potential with its switch moved out of the way of fracture, in a file of its own.
Potential with_switch_at(const std::string& name, const std::string& length) {
  Potential moved = potential(name);
  std::ifstream in(moved.file);
  const auto file = std::filesystem::temp_directory_path() / ("switch-" + std::to_string(getpid()) + "-" + name);
  std::ofstream out(file);
  for (std::string line; std::getline(in, line); out << line << '\n')
    if (const auto at = line.find("1.7"); at != std::string::npos && line.find("rcmin_CC") != std::string::npos)
      line.replace(at, 3, length);
  moved.file = file.string();
  moved.artefact_bond_A = std::stod(length);
  return moved;
}

/// Where the path breaks its last step is halved until the force is known to 1 %; a search that is taken up again finds
/// the same.
TEST(Indentation, ABreakIsBracketedAndTheSearchCanBeResumed) {
  Problem p = problem_of("rebo", 14, DiscLoad{5}, {2, 4, 5, 5.75, 6.5, 7.25, 8});
  p.potential = with_switch_at("rebo", "1.92");
  const Path whole = follow(p);
  ASSERT_EQ(whole.report.ended, Ended::rupture) << whole.report.reason;
  EXPECT_EQ(whole.report.reason, "a bond of the sheet has broken");
  const auto first = std::ranges::find_if(whole.steps, [](const Step& s) { return s.broken; });
  ASSERT_NE(first, whole.steps.end());
  const auto tries = static_cast<std::size_t>(whole.steps.end() - first) - 1;
  EXPECT_GE(tries, 2u);
  EXPECT_LE(tries, 6u);
  double borne = (first - 1)->target, broken = first->target, force = (first - 1)->force_eV_per_A;
  int evaluations = 0;
  for (auto step = first + 1; step != whole.steps.end(); ++step) {
    EXPECT_TRUE(step->search);
    EXPECT_NEAR(step->target, (borne + broken) / 2, 1e-12);
    evaluations += step->evaluations;
    if (!step->broken) {
      EXPECT_TRUE(step->converged);
      EXPECT_NEAR(step->force_eV_per_A / force, 1, 0.03) << "a depth that is borne lies on the curve";
      force = step->force_eV_per_A;
    }
    (step->broken ? broken : borne) = step->target;
  }
  EXPECT_LT((broken - borne) / borne, 0.012);
  EXPECT_LT(evaluations, 60 * static_cast<int>(tries));
  for (std::size_t kept = static_cast<std::size_t>(first - whole.steps.begin()) + 1; kept < whole.steps.size();
       ++kept) {
    const Path rest = follow(p, {whole.steps.begin(), whole.steps.begin() + static_cast<long>(kept)});
    EXPECT_EQ(rest.report.ended, Ended::rupture);
    ASSERT_EQ(rest.steps.size(), whole.steps.size() - kept);
    for (std::size_t i = 0; i < rest.steps.size(); ++i) {
      EXPECT_EQ(rest.steps[i].evaluations, whole.steps[kept + i].evaluations);
      EXPECT_NEAR(rest.steps[i].force_eV_per_A, whole.steps[kept + i].force_eV_per_A, 1e-8 * force);
    }
  }
}

TEST(Indentation, ASearchThatFailsInTheArtefactZoneEndsThePathThere) {
  Problem p = problem_of("rebo", 20, PointLoad{}, {12});
  p.past_artefact = true;
  p.max_evaluations = 2;  // the first guess of one deep step has bonds beyond the artefact length
  const Path path = follow(p);
  EXPECT_FALSE(path.steps.back().converged);
  EXPECT_GE(path.steps.back().longest_bond_A, 1.70);
  EXPECT_NE(path.report.ended, Ended::not_converged);
}

TEST(Indentation, NotConvergingIsReportedWithThePathSoFar) {
  Problem p = problem_of("tersoff", 20, DiscLoad{6}, {1, 2});
  p.max_evaluations = 4;
  const Path path = follow(p);
  EXPECT_EQ(path.report.ended, Ended::not_converged);
  ASSERT_EQ(path.steps.size(), 1u);
  EXPECT_FALSE(path.steps[0].converged);
  EXPECT_FALSE(path.report.reason.empty());
}

}  // namespace
