#include "atomistic/loads/load_term.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "atomistic/loads/pattern_load.hpp"
#include "atomistic/loads/pressure_load.hpp"

namespace {

using namespace atomistic;
using Eigen::VectorXd;

/// Every load in both kinds of control, at a level that a 20 Å sheet of 2 Å depth would see.
struct LoadCase {
  const char* name;
  Load load;
  Control control;
  double level;
};
const LoadCase load_cases[] = {{"point_depth", PointLoad{}, Control::conjugate_depth, 2},
                               {"point_force", PointLoad{}, Control::force, 1},
                               {"disc_depth", DiscLoad{6}, Control::conjugate_depth, 2},
                               {"disc_force", DiscLoad{6}, Control::force, 1},
                               {"sphere_depth", SphereLoad{.radius_A = 8}, Control::conjugate_depth, 2},
                               {"sphere_force", SphereLoad{.radius_A = 8}, Control::force, 1},
                               {"pressure_following", PressureLoad{true}, Control::force, 2e-3},
                               {"pressure_dead", PressureLoad{false}, Control::force, 2e-3}};

Problem problem_of(const LoadCase& c) {
  Problem p;
  p.card = {.a0_A = 2.46,
            .C11_eV_per_A2 = 20,
            .C12_eV_per_A2 = 7,
            .C66_eV_per_A2 = 6.5,
            .bending_modulus_zigzag_eV = 1,
            .bending_modulus_armchair_eV = 1};
  p.radius_A = 20;
  p.load = c.load;
  p.control = c.control;
  return p;
}

class LoadOf : public testing::TestWithParam<LoadCase> {
 protected:
  Problem problem = problem_of(GetParam());
  Sheet sheet = make_sheet(20, 2.46, 0, 5);
  std::unique_ptr<LoadTerm> load = make_load(problem, sheet);

  /// A dent of 2 Å, bumpy so that nothing vanishes by symmetry.
  VectorXd dented() const {
    VectorXd x = sheet.positions.head(3 * sheet.free_atoms) + schwerin_shape(sheet, 2);
    for (Eigen::Index i = 0; i < x.size(); ++i) x[i] += 0.02 * std::sin(3.7 * static_cast<double>(i));
    return x;
  }
  void SetUp() override { load->set_level(GetParam().level); }
};

/// By the order of the central difference's error; exact for linear loads.
TEST_P(LoadOf, GradientIsTheEnergys) {
  const VectorXd x = dented();
  VectorXd gradient = VectorXd::Zero(x.size()), unused = gradient;
  load->add(x, gradient);
  VectorXd direction = VectorXd::Zero(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) direction[i] = std::cos(1.3 * static_cast<double>(i));
  const auto error = [&](double h) {
    return std::abs((load->add(x + h * direction, unused) - load->add(x - h * direction, unused)) / (2 * h) -
                    gradient.dot(direction));
  };
  const double coarse = error(2e-3), fine = error(1e-3), rounding = 1e-9 * (1 + gradient.norm());
  EXPECT_TRUE(coarse < rounding || std::abs(coarse / fine - 4) < 0.6) << coarse << " " << fine;
}

/// The force is what the depth's change works against: at held force, energy − stored = −F d.
TEST_P(LoadOf, DeadWorkIsForceTimesDepth) {
  const VectorXd x = dented();
  const double expected = GetParam().control == Control::force ? -load->force(x, 0) * load->conjugate_depth(x) : 0.0;
  EXPECT_NEAR(load->dead_work(x), expected, 1e-9 * std::abs(expected));
}

TEST_P(LoadOf, ParameterGrowsAndItsFirstGuessGoesDown) {
  EXPECT_GT(load->parameter(2 * GetParam().level), load->parameter(GetParam().level));
  const VectorXd u = load->first_guess();
  EXPECT_LT(u[3 * sheet.record[0] + 2], -0.1);
  EXPECT_LE(u.maxCoeff(), 0);
}

/// A held force's stiffness less what is given back is the Hessian of the load's energy, up to the turning of the
/// contact's normals, which is left out; it stays positive semi-definite.
TEST_P(LoadOf, StiffnessIsPositiveEvenAfterGivingBack) {
  const VectorXd x = dented(), k = load->given_back(x);
  const auto blocks = load->stiffness(x);
  VectorXd v = VectorXd::Zero(x.size());
  for (int trial = 0; trial < 20; ++trial) {
    for (const auto& [atom, stiffness] : blocks)
      v.segment<3>(3 * atom) = Eigen::Vector3d(std::sin(trial + atom), std::cos(3 * trial + atom), 1);
    double energy = 0;
    for (const auto& [atom, stiffness] : blocks)
      energy += v.segment<3>(3 * atom).dot(stiffness * v.segment<3>(3 * atom));
    if (k.size()) energy -= std::pow(k.dot(v), 2);
    EXPECT_GE(energy, -1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(All, LoadOf, testing::ValuesIn(load_cases),
                         [](const auto& param_info) { return std::string(param_info.param.name); });

TEST(PatternLoad, WeightsAreNotNegativeAndSumToOneAlongZ) {
  const Sheet sheet = make_sheet(20, 2.46, 0, 5);
  const Problem problem = problem_of(load_cases[0]);
  for (const Load& load : {Load(PointLoad{}), Load(DiscLoad{8})}) {
    const PatternLoad pattern(loaded_atoms(load, sheet), problem, sheet);
    EXPECT_NEAR(pattern.direction().sum(), 1.0, 1e-13);
    EXPECT_GE(pattern.direction().minCoeff(), 0.0);
    for (Eigen::Index i = 0; i < pattern.direction().size(); ++i)
      EXPECT_TRUE(i % 3 == 2 || pattern.direction()[i] == 0.0);
  }
}

TEST(PatternLoad, RefusesADiscThatHoldsNothingOrTheClamp) {
  const Sheet sheet = make_sheet(20, 2.46, 0, 5);
  Problem problem = problem_of(load_cases[2]);
  for (double radius : {0.5, 22.0}) {
    problem.load = DiscLoad{radius};
    EXPECT_THROW(make_load(problem, sheet), std::invalid_argument) << radius;
  }
}

TEST(SphereLoad, HeldForceFindsTheTravelOfThatForce) {
  const Sheet sheet = make_sheet(20, 2.46, 0, 5);
  const Problem held_depth = problem_of(load_cases[4]), held_force = problem_of(load_cases[5]);
  const auto depth = make_load(held_depth, sheet), force = make_load(held_force, sheet);
  const VectorXd x = sheet.positions.head(3 * sheet.free_atoms) + schwerin_shape(sheet, 2);
  depth->set_level(2.3);
  force->set_level(depth->force(x, 0));
  EXPECT_NEAR(force->conjugate_depth(x), 2.3, 1e-10);
}

TEST(SphereLoad, AdmitsNoDeepPenetration) {
  const Sheet sheet = make_sheet(20, 2.46, 0, 5);
  const Problem problem = problem_of(load_cases[4]);
  const auto load = make_load(problem, sheet);
  load->set_level(3);
  VectorXd x = sheet.positions.head(3 * sheet.free_atoms), gradient = VectorXd::Zero(x.size());
  load->admit(x);  // the flat sheet cuts 3 Å into the sphere
  load->add(x, gradient);
  for (int i = 0; i < sheet.free_atoms; ++i) EXPECT_LE(gradient.segment<3>(3 * i).norm(), 0.1 + 1e-9);
}

/// The flat sheet's share of an atom is the area per atom; the volume under a sheet lowered by h is h times the area.
TEST(PressureLoad, FlatSheetGetsTheAreaPerAtom) {
  const Sheet sheet = make_sheet(20, 2.46, 0, 5);
  Problem problem = problem_of(load_cases[6]);
  const PressureTerm pressure(PressureLoad{}, problem, sheet);
  VectorXd share;
  const VectorXd flat = sheet.positions.head(3 * sheet.free_atoms);
  EXPECT_NEAR(pressure.volume(flat, share), 0, 1e-9);
  const double per_atom = std::sqrt(3) / 4 * 2.46 * 2.46;
  for (int i = 0; i < sheet.free_atoms; ++i)
    EXPECT_LT((share.segment<3>(3 * i) - Eigen::Vector3d(0, 0, -per_atom)).norm(), 1e-9);
  EXPECT_NEAR(pressure.flat_area_A2(), std::numbers::pi * 21 * 21, 0.05 * pressure.flat_area_A2());
}

/// A cone over the disc: V = area × depth / 3, whatever the in-plane places are.
TEST(PressureLoad, VolumeOfACone) {
  const Sheet sheet = make_sheet(60, 2.46, 0, 5);
  const PressureTerm pressure(PressureLoad{}, problem_of(load_cases[6]), sheet);
  VectorXd x = sheet.positions.head(3 * sheet.free_atoms), unused;
  for (int i = 0; i < sheet.free_atoms; ++i) x[3 * i + 2] = -5 * (1 - sheet.position(i).head<2>().norm() / 60);
  EXPECT_NEAR(pressure.volume(x, unused), std::numbers::pi * 60 * 60 * 5 / 3,
              0.01 * std::numbers::pi * 60 * 60 * 5 / 3);
}

TEST(PressureLoad, HasNoControlledDepth) {
  const Sheet sheet = make_sheet(20, 2.46, 0, 5);
  Problem problem = problem_of(load_cases[6]);
  problem.control = Control::conjugate_depth;
  EXPECT_THROW(make_load(problem, sheet), std::invalid_argument);
}

}  // namespace
