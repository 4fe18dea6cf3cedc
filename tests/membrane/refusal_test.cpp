// Problems that make no sense are refused before anything is solved, naming the member.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <ostream>
#include <string>

#include "membrane/problem.hpp"

namespace membrane {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

Problem good() {
  Problem problem;
  problem.sheet = DiscSheet{.radius_A = 110, .rings = 16};
  problem.law = StVenantKirchhoff{8, 0.19};
  problem.load = DiscLoad{10};
  problem.levels = {2};
  return problem;
}

struct Bad {
  const char* member;
  std::function<void(Problem&)> spoil;
};

/// The test's name in listings; without it, the bytes of the object.
void PrintTo(const Bad& bad, std::ostream* out) { *out << bad.member; }

class Refusal : public ::testing::TestWithParam<Bad> {};

TEST_P(Refusal, NamesTheMember) {
  Problem problem = good();
  GetParam().spoil(problem);
  bool called = false;
  try {
    solve(problem, [&](const Step&) { return called = true; });
    FAIL() << "not refused";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(GetParam().member), std::string::npos) << error.what();
  }
  EXPECT_FALSE(called);
}

INSTANTIATE_TEST_SUITE_P(
    Problems, Refusal,
    ::testing::Values(Bad{"sheet.radius_A", [](Problem& p) { std::get<DiscSheet>(p.sheet).radius_A = 0; }},
                      Bad{"sheet.radius_A", [](Problem& p) { std::get<DiscSheet>(p.sheet).radius_A = nan; }},
                      Bad{"sheet.radius_A", [](Problem& p) { std::get<DiscSheet>(p.sheet).radius_A = inf; }},
                      Bad{"sheet.rings", [](Problem& p) { std::get<DiscSheet>(p.sheet).rings = 3; }},
                      Bad{"sheet.rings", [](Problem& p) { std::get<DiscSheet>(p.sheet).rings = 1000000; }},
                      Bad{"law.nu",
                          [](Problem& p) {
                            p.law = StVenantKirchhoff{8, 1};
                          }},
                      Bad{"law.nu",
                          [](Problem& p) {
                            p.law = StVenantKirchhoff{8, -1};
                          }},
                      Bad{"law.nu",
                          [](Problem& p) {
                            p.law = StVenantKirchhoff{8, nan};
                          }},
                      Bad{"law.sheet_modulus_eV_per_A2",
                          [](Problem& p) {
                            p.law = StVenantKirchhoff{0, 0.19};
                          }},
                      Bad{"law.sheet_modulus_eV_per_A2",
                          [](Problem& p) {
                            p.law = StVenantKirchhoff{nan, 0.19};
                          }},
                      Bad{"law.zigzag_rad", [](Problem& p) { p.law = CauchyBornSixfold{8, 0.19, 0.1, {}}; }},
                      Bad{"prestress_eV_per_A2(0,1)",
                          [](Problem& p) {
                            p.law = CauchyBornSixfold{8, 0.19, 0, {}};
                            p.prestress_eV_per_A2(0, 1) = p.prestress_eV_per_A2(1, 0) = 0.1;
                          }},
                      Bad{"law.coefficients_eV_per_A2", [](Problem& p) { p.law = CauchyBornTable{8, 0.19, {-0.1, 0.3, 2}, {0, 0.1, 2}, {}}; }},
                      Bad{"prestress_eV_per_A2", [](Problem& p) { p.prestress_eV_per_A2(1, 1) = nan; }},
                      Bad{"prestress_eV_per_A2(0,1)", [](Problem& p) { p.prestress_eV_per_A2(0, 1) = 0.1; }},
                      Bad{"load.radius_A", [](Problem& p) { p.load = DiscLoad{0}; }},
                      Bad{"load.radius_A", [](Problem& p) { p.load = DiscLoad{-1}; }},
                      Bad{"load.radius_A", [](Problem& p) { p.load = DiscLoad{nan}; }},
                      Bad{"load.radius_A", [](Problem& p) { p.load = DiscLoad{120}; }},
                      Bad{"record_radius_A", [](Problem& p) { p.record_radius_A = 110; }},
                      Bad{"record_radius_A", [](Problem& p) { p.record_radius_A = nan; }},
                      Bad{"levels", [](Problem& p) { p.levels = {}; }},
                      Bad{"levels",
                          [](Problem& p) {
                            p.levels = {2, 0};
                          }},
                      Bad{"levels",
                          [](Problem& p) {
                            p.levels = {2, -1};
                          }},
                      Bad{"levels", [](Problem& p) { p.levels = {nan}; }},
                      Bad{"prestress_eV_per_A2",
                          [](Problem& p) {
                            p.prestress_eV_per_A2 = -0.1 * Eigen::Matrix2d::Identity();
                            p.levels = {0};
                          }},
                      Bad{"load.radius_A", [](Problem& p) { p.load = SphereLoad{120}; }},
                      Bad{"load.radius_A", [](Problem& p) { p.load = SphereLoad{nan}; }},
                      Bad{"load.density", [](Problem& p) { p.load = RadialLoad{{0, 10}, {1, nan}}; }},
                      Bad{"pressure_eV_per_A3", [](Problem& p) { p.pressure_eV_per_A3 = nan; }},
                      Bad{"discretisation.relative_residual", [](Problem& p) { p.discretisation = Triangles{.relative_residual = nan}; }},
                      Bad{"discretisation.most_iterations", [](Problem& p) { p.discretisation = Triangles{.most_iterations = 0}; }},
                      Bad{"sheet.rim",
                          [](Problem& p) { std::get<DiscSheet>(p.sheet).rim = Support::free; }}));

RectangleSheet strip() {
  return {.length_x_A = 40,
          .length_y_A = 20,
          .cells_x = 8,
          .cells_y = 4,
          .extent = Extent::full,
          .left = Support::clamped,
          .right = Support::clamped,
          .bottom = Support::free,
          .top = Support::free};
}

/// A strip whose right edge moves.
Problem pulled(RectangleSheet sheet, EdgeMotion motion) {
  Problem problem = good();
  problem.sheet = sheet;
  problem.load = motion;
  problem.levels = {1};
  return problem;
}

struct Contradiction {
  const char* member;
  std::function<Problem()> problem;
};

void PrintTo(const Contradiction& c, std::ostream* out) { *out << c.member; }

class Contradictory : public ::testing::TestWithParam<Contradiction> {};

TEST_P(Contradictory, SupportsAreRefused) {
  try {
    check(GetParam().problem());
    FAIL() << "not refused";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(GetParam().member), std::string::npos) << error.what();
  }
}

const EdgeMotion along{.edge = Edge::right, .translation_A = {1, 0, 0}};
const EdgeMotion across{.edge = Edge::right, .translation_A = {0, 0, 1}};
const EdgeMotion turned{.edge = Edge::right, .rotation_rad = 0.1};

INSTANTIATE_TEST_SUITE_P(
    Supports, Contradictory,
    ::testing::Values(Contradiction{"load.edge",  // a corner both moves and stays
                                    [] {
                                      RectangleSheet sheet = strip();
                                      sheet.top = Support::clamped;
                                      return pulled(sheet, along);
                                    }},
                      Contradiction{"load.edge",  // a corner leaves the plane that the other edge keeps to
                                    [] {
                                      RectangleSheet sheet = strip();
                                      sheet.top = Support::sliding;
                                      return pulled(sheet, across);
                                    }},
                      Contradiction{"load.edge",  // moves, but is not held
                                    [] {
                                      RectangleSheet sheet = strip();
                                      sheet.right = Support::sliding;
                                      return pulled(sheet, along);
                                    }},
                      Contradiction{"load.edge",
                                    [] { return pulled(strip(), {.edge = Edge::hub, .rotation_rad = 0.1}); }},
                      Contradiction{"load.translation_A", [] { return pulled(strip(), {.edge = Edge::right}); }},
                      Contradiction{"load.translation_A",  // out of the symmetry plane
                                    [] {
                                      RectangleSheet sheet = strip();
                                      sheet.extent = Extent::quarter;
                                      return pulled(sheet, turned);
                                    }},
                      Contradiction{"load.translation_A",
                                    [] {
                                      Problem problem = good();
                                      problem.load = EdgeMotion{.edge = Edge::rim, .translation_A = {1, 0, 0}};
                                      problem.levels = {1};
                                      return problem;
                                    }},
                      Contradiction{"sheet.extent",
                                    [] {
                                      RectangleSheet sheet = strip();
                                      sheet.extent = Extent::quarter;
                                      sheet.left = Support::free;
                                      return pulled(sheet, along);
                                    }},
                      Contradiction{"sheet",  // nothing bears the load
                                    [] {
                                      Problem problem = good();
                                      RectangleSheet sheet = strip();
                                      sheet.left = sheet.right = Support::free;
                                      problem.sheet = sheet;
                                      problem.load = DiscLoad{5};
                                      return problem;
                                    }},
                      Contradiction{"load",  // a pressure on an open edge
                                    [] {
                                      Problem problem = good();
                                      problem.sheet = strip();
                                      problem.load = PressureLoad{};
                                      return problem;
                                    }}));

TEST(Contradictory, WhatMakesSenseIsNot) {
  EXPECT_NO_THROW(check(pulled(strip(), along)));
  EXPECT_NO_THROW(check(pulled(strip(), across)));
  EXPECT_NO_THROW(check(pulled(strip(), turned)));
}

TEST(Refusal, GoodProblemIsSolved) {
  EXPECT_TRUE(solve(good(), [](const Step&) { return true; }).converged);
}

}  // namespace
}  // namespace membrane
