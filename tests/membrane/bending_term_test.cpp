// Bending within the total energy of a mesh, against the one-dimensional sheet.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "membrane/bending/term.hpp"
#include "membrane/loads/pattern.hpp"
#include "membrane/problem.hpp"
#include "membrane/sheets/sheet.hpp"
#include "membrane/terms/stretching.hpp"
#include "membrane/triangles/newton.hpp"
#include "taylor.hpp"

namespace membrane::testing {
namespace {

constexpr double a = 110;
constexpr double c = 10;
const StVenantKirchhoff law{17.33, 0.3645};
constexpr double kappa = 0.966;

/// One quarter of a clamped disc that stretches and bends.
struct BentDisc {
  Mesh mesh;
  Stretching stretching;
  BendingTerm bending;
  TotalEnergy total;
  Pattern pattern;

  explicit BentDisc(int rings)
      : mesh(make_mesh(DiscSheet{.radius_A = a, .rings = rings, .spacing = RingSpacing::uniform}, {c, 0})),
        stretching(mesh, {law, Voigt::Zero(), false}),
        bending(mesh, clamped_all_round(kappa), mesh.node_count()),
        total(all_held(), {&stretching, &bending}),
        pattern(radial_pattern(mesh, c, [](double) { return 1.0; })) {}

  Held all_held() const {
    Held held = mesh.held;
    const Held rotations = bending.held_rotations();
    held.insert(held.end(), rotations.begin(), rotations.end());
    return held;
  }
  Eigen::VectorXd direction() const {
    Eigen::VectorXd all = Eigen::VectorXd::Zero(total.dof_count());
    const Eigen::VectorXd of_nodes = pattern.direction();
    all.head(of_nodes.size()) = of_nodes;
    return all;
  }
};

TEST(BendingTerm, HessianIsThatOfTheEnergy) {
  BentDisc disc(8);
  Eigen::VectorXd u =
      Eigen::VectorXd::NullaryExpr(disc.total.dof_count(), [](Eigen::Index i) { return std::sin(3.7 * i); });
  Eigen::VectorXd v = Eigen::VectorXd::NullaryExpr(u.size(), [](Eigen::Index i) { return std::cos(1.3 * i * i); });
  disc.total.release_held(u);
  disc.total.release_held(v);
  Eigen::VectorXd gradient, other;
  const double energy = disc.total.energy(u, gradient);
  const Hessian::Matrix& K = disc.total.hessian(u);
  Eigen::VectorXd Kv = K.selfadjointView<Eigen::Lower>() * v;
  expect_order([&](double t) { return std::abs(disc.total.energy(u + t * v, other) - energy - t * gradient.dot(v)); },
               1e-4, 2, 1e-12 * energy);
  expect_order(
      [&](double t) {
        disc.total.energy(u + t * v, other);
        Eigen::VectorXd difference = other - gradient - t * Kv;
        disc.total.release_held(difference);
        return difference.norm();
      },
      1e-4, 2, 1e-12 * gradient.norm());
  // What is left without the folds' directions is positive semi-definite.
  Hessian::Matrix convex = disc.total.hessian(u, 1);
  Factor factor;
  for (Eigen::Index i = 0; i < convex.rows(); ++i) convex.coeffRef(i, i) += 1e-10;
  EXPECT_TRUE(factor.factorise(convex));
}

// From bending to stretching: the force at equal conjugate depth. Rings as wide as the boundary layers,
// √(κ/N), which are 2 to 4 Å here.
TEST(BendingTerm, DiscIsTheOneDimensionalSheet) {
  const std::vector<double> depths{0.01, 4, 8, 16};
  std::vector<double> exact;
  Problem problem;
  problem.discretisation = Meridian{};
  problem.sheet = DiscSheet{a};
  problem.law = law;
  problem.relaxed = false;
  problem.bending = clamped_all_round(kappa);
  problem.load = DiscLoad{c};
  problem.levels = depths;
  solve(problem, [&](const Step& step) {
    exact.push_back(step.force_eV_per_A);
    return true;
  });
  const auto errors = [&](int rings) {
    BentDisc disc(rings);
    Newton newton(disc.total, disc.direction(), {});
    Eigen::VectorXd u = Eigen::VectorXd::Zero(disc.total.dof_count());
    std::vector<double> errors_at;
    double before = 0;
    for (std::size_t i = 0; i < depths.size(); ++i) {
      const Eigen::VectorXd response = newton.linear_response(u, disc.direction());
      u = before == 0 ? Eigen::VectorXd(response * (depths[i] / disc.direction().dot(response)))
                      : Eigen::VectorXd(u * (depths[i] / before));
      const Equilibrium at = newton.solve({Control::conjugate_depth, depths[i]}, u);
      EXPECT_TRUE(at.converged) << at.reason;
      errors_at.push_back(disc.mesh.copies * at.force_eV_per_A / exact[i] - 1);
      std::cout << rings << " rings, depth " << depths[i] << ": " << errors_at.back() << " in force, " << at.iterations
                << " steps\n";
      before = depths[i];
    }
    return errors_at;
  };
  const auto coarse = errors(33);
  const auto fine = errors(66);
  for (std::size_t i = 0; i < depths.size(); ++i) EXPECT_LE(std::abs(fine[i]), 1e-3) << depths[i];
  EXPECT_LE(std::abs(fine[0]), 0.3 * std::abs(coarse[0]));
}

}  // namespace
}  // namespace membrane::testing
