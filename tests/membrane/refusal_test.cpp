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
                      Bad{"levels", [](Problem& p) { p.levels = {nan}; }}));

TEST(Refusal, GoodProblemIsSolved) {
  EXPECT_TRUE(solve(good(), [](const Step&) { return true; }).converged);
}

}  // namespace
}  // namespace membrane
