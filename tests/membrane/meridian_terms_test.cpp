// The round sheet's parts: every term of its energy, the sum over elements, the factor, the mesh.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <functional>
#include <random>

#include "membrane/meridian/assembly.hpp"
#include "membrane/meridian/mesh.hpp"
#include "membrane/meridian/setup.hpp"
#include "states.hpp"
#include "taylor.hpp"

namespace membrane::meridian {
namespace {

using membrane::testing::expect_order;

class Random {
 public:
  Eigen::VectorXd operator()(Eigen::Index size) {
    return Eigen::VectorXd::NullaryExpr(size, [&] { return any_(generator_); });
  }

 private:
  std::mt19937 generator_{20100407};
  std::uniform_real_distribution<double> any_{-1, 1};
};

struct NamedTerm {
  std::string name;
  std::function<Density(const LocalState&)> density;
};

constexpr double s = 14.0;
const Ring ring{s, 2.5};
std::vector<NamedTerm> all_terms() {
  std::vector<NamedTerm> terms;
  const auto add = [&](const std::string& name, auto term) {
    terms.push_back({name, [term](const LocalState& y) { return term(ring, y); }});
  };
  add("bending", Bending{0.966});
  add("pressure", Pressure{0.003});
  add("contact, under the sphere", SphereContact{20, 14, 0.3});
  add("contact, beside the cylinder", SphereContact{11, 40, 0.3});
  for (const auto& [name, law] : example_laws()) {
    add("stretching, " + name, Stretching{law, 0.01, false, 0});
    add("relaxed stretching, " + name, Stretching{law, 0.01, true, 0});
  }
  return terms;
}

// Rotated by 50°, stretched, curved: nothing is small.
const LocalState tilted = (LocalState() << 0.4, -0.32, 0.03, 12.0, -0.82, -0.05).finished();

TEST(MeridianTerm, DerivativesAreThoseOfTheEnergy) {
  Random random;
  for (const auto& [name, density] : all_terms()) {
    SCOPED_TRACE(name);
    for (int trial = 0; trial < 4; ++trial) {
      const LocalState y = tilted + 0.02 * LocalState(random(6));
      const LocalState v = random(6);
      const Density at = density(y);
      const double size = 1 + at.hessian.norm();
      expect_order([&](double t) { return std::abs(density(y + t * v).value - at.value - t * at.gradient.dot(v)); },
                   1e-4, 2, 1e-15 * size);
      expect_order([&](double t) { return (density(y + t * v).gradient - at.gradient - t * at.hessian * v).norm(); },
                   1e-4, 2, 1e-14 * size);
      EXPECT_LE((at.hessian - at.hessian.transpose()).norm(), 1e-14 * size);
    }
  }
}

// u, w of a meridian given as r(s), z(s) with derivatives.
LocalState on_curve(double r, double r1, double r2, double z, double z1, double z2) {
  return (LocalState() << r - s, r1 - 1, r2, z, z1, z2).finished();
}

TEST(MeridianTerm, BendingOfASphereIsExactAtAnyRotationAndStretch) {
  const double R = 9;
  for (double pace : {1 / R, 0.7 / R, 1.4 / R})  // angle over reference radius: unstretched, shortened, stretched
    for (double angle : {0.1, 0.8, 1.57, 2.5}) {
      const double c = std::cos(angle);
      const double sn = std::sin(angle);
      const LocalState y =
          on_curve(R * sn, R * pace * c, -R * pace * pace * sn, -R * (1 - c), -R * pace * sn, -R * pace * pace * c);
      EXPECT_NEAR(Bending{0.966}(ring, y).value, 0.5 * 0.966 * 4 / (R * R), 1e-15);
    }
}

TEST(MeridianTerm, BendingOfAConeIsThatOfItsHoops) {
  const double slope = 1.1;  // angle to the plane
  const double r = 7;
  const LocalState y = on_curve(r, 1.2 * std::cos(slope), 0, -3, -1.2 * std::sin(slope), 0);
  EXPECT_NEAR(Bending{2}(ring, y).value, std::pow(std::sin(slope) / r, 2), 1e-15);
}

TEST(MeridianTerm, BendingDoesNotSeeHowTheMeridianIsParametrised) {
  // A torus-like bend about a circle, walked at an uneven pace: u'' and w'' have parts along the meridian.
  const auto value = [&](double pace, double acceleration) {
    const double angle = 0.6;
    const double c = std::cos(angle);
    const double sn = std::sin(angle);
    const double R = 5;
    return Bending{1}(ring, on_curve(12 + R * sn, R * pace * c, R * (acceleration * c - pace * pace * sn), R * c,
                                     -R * pace * sn, -R * (acceleration * sn + pace * pace * c)))
        .value;
  };
  EXPECT_NEAR(value(0.2, 0.05), value(0.2, 0), 1e-16);
  EXPECT_NEAR(value(0.35, -0.3), value(0.2, 0), 1e-16);
}

TEST(MeridianTerm, VolumeOfAConeAndASphericalCap) {
  Problem problem;
  problem.sheet = DiscSheet{10};
  problem.law = StVenantKirchhoff{8, 0.2};
  problem.load = PressureLoad{};
  problem.discretisation = Meridian{.refinement = 4};
  Assembly assembly = assembly_of(problem);
  const auto volume = [&](auto depth, auto slope) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(assembly.dof_count());
    for (int n = 0; n <= assembly.element_count(); ++n) {
      x[dofs_per_node * n + 2] = depth(assembly.nodes()[n]);
      x[dofs_per_node * n + 3] = slope(assembly.nodes()[n]);
    }
    return -assembly.sum(x, [](const Ring& at, const LocalState& y) { return at.area_A2 * Pressure{1}(at, y).value; });
  };
  const double pi = std::acos(-1);
  EXPECT_NEAR(volume([](double r) { return 0.3 * (10 - r); }, [](double) { return -0.3; }), pi * 1000 * 0.3 / 3, 1e-9);
  const double R = 12.5;  // cap of depth 5: 100 = 5 (2 R − 5)
  EXPECT_NEAR(volume([&](double r) { return std::sqrt(R * R - r * r) - (R - 5); },
                     [&](double r) { return -r / std::sqrt(R * R - r * r); }),
              pi * 25 * (3 * R - 5) / 3, 1e-5);
}

TEST(MeridianAssembly, GradientAndHessianAreThoseOfTheEnergy) {
  Random random;
  Problem problem;
  problem.discretisation = Meridian{};
  problem.sheet = DiscSheet{30};
  problem.law = membrane::testing::some_lattice();
  problem.relaxed = false;
  problem.bending = clamped_all_round(0.966);
  problem.prestress_eV_per_A2 = 0.05 * Eigen::Matrix2d::Identity();
  problem.pressure_eV_per_A3 = 1e-3;
  problem.load = SphereLoad{10};
  Assembly assembly = assembly_of(problem);
  assembly.contact() = SphereContact{10, 2.9, 0.02};
  Eigen::VectorXd x = 3 * tip_shape(problem, assembly, {});
  assembly.start_pressures(x);
  Eigen::VectorXd v = random(x.size());
  assembly.release_held(v);
  for (int n = 0; n <= assembly.element_count(); ++n) {  // smooth enough for finite strains
    v.segment<dofs_per_node>(dofs_per_node * n) *= 0.02;
  }
  Eigen::VectorXd gradient;
  const double energy = assembly.energy(x, gradient);
  BlockTridiagonal K(assembly.element_count() + 1);
  assembly.hessian(x, K);
  Eigen::VectorXd Kv = K * v;
  assembly.release_held(Kv);
  Eigen::VectorXd other;
  expect_order([&](double t) { return std::abs(assembly.energy(x + t * v, other) - energy - t * gradient.dot(v)); },
               1e-2, 2, 1e-10);
  expect_order(
      [&](double t) {
        assembly.energy(x + t * v, other);
        return (other - gradient - t * Kv).norm();
      },
      1e-2, 2, 1e-9);
}

TEST(BlockCholesky, SolvesWhatADenseFactorSolves) {
  Random random;
  const int nodes = 5;
  BlockTridiagonal K(nodes);
  for (Block& block : K.diagonal) {
    const Block any = Block::NullaryExpr([&] { return random(1)[0]; });
    block = any * any.transpose() + 6 * Block::Identity();
  }
  for (Block& block : K.below) block = Block::NullaryExpr([&] { return random(1)[0]; });
  K.hold(6);
  Eigen::MatrixXd dense(4 * nodes, 4 * nodes);
  for (int i = 0; i < 4 * nodes; ++i) dense.col(i) = K * Eigen::VectorXd::Unit(4 * nodes, i);
  EXPECT_EQ(dense, dense.transpose());
  EXPECT_EQ(dense.col(6), Eigen::VectorXd::Unit(4 * nodes, 6));
  BlockCholesky factor;
  ASSERT_TRUE(factor.factorise(K));
  const Eigen::VectorXd b = random(4 * nodes);
  EXPECT_LE((factor.solve(b) - dense.llt().solve(b)).norm(), 1e-13);
  K.diagonal[3](2, 2) = -1;
  EXPECT_FALSE(factor.factorise(K));
  EXPECT_TRUE(factor.factorise(K, 30));
  K.diagonal[3](2, 2) = std::nan("");
  EXPECT_FALSE(factor.factorise(K, 30));
}

TEST(MeridianMesh, FollowsItsFoci) {
  const std::vector<Focus> foci{{0, 0, 0.5}, {10, 10, 0.2}, {100, 100, 0.7}};
  const auto radii = graded_radii(100, {10}, foci, 0.3, 4);
  EXPECT_EQ(radii.front(), 0);
  EXPECT_EQ(radii.back(), 100);
  EXPECT_NE(std::find(radii.begin(), radii.end(), 10.0), radii.end());
  for (std::size_t i = 1; i < radii.size(); ++i) {
    const double length = radii[i] - radii[i - 1];
    ASSERT_GT(length, 0.05);
    for (const Focus& focus : foci) {
      const double away = std::max(std::abs(radii[i] - focus.from_A), std::abs(radii[i - 1] - focus.from_A));
      EXPECT_LE(length, 1.5 * std::min(4.0, focus.size_A + 0.3 * away));
    }
  }
  EXPECT_LT(radii.size(), 110);
}

}  // namespace
}  // namespace membrane::meridian
