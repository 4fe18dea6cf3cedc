// Bending on triangles: derivatives, rigid motions, constant curvature, plates, cylinders, a rolled strip.
#include "membrane/bending/bending.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <tuple>

#include "plate_meshes.hpp"
#include "plate_solver.hpp"
#include "taylor.hpp"

namespace membrane::testing {
namespace {

using std::numbers::pi;

constexpr BendingModuli moduli{0.966, -0.7};

SlopeSupport held(int, int) { return SlopeSupport::held; }
SlopeSupport free_edge(int, int) { return SlopeSupport::free; }

PlateMesh irregular_disc(double radius, int rings) {
  PlateMesh mesh = hexagonal_disc(radius, rings);
  const double h = radius / rings;
  jitter(mesh, 0.2 * h);
  flip_edges(mesh, 0.3 * h * h);
  return mesh;
}

Bending bending_of(const PlateMesh& mesh, SlopeSupport (*slope)(int, int), BendingModuli m = moduli) {
  return {mesh.nodes, mesh.triangles, m, slope};
}

Eigen::VectorXd random_vector(Eigen::Index size) {
  std::mt19937 random(20100407);
  std::uniform_real_distribution<double> any(-1, 1);
  return Eigen::VectorXd::NullaryExpr(size, [&] { return any(random); });
}

TEST(Hinge, DerivativesAreThoseOfTheAngle) {
  const HingeCorners flat{Eigen::Vector3d(0, 0, 0), {2, 0.3, 0.1}, {0.7, 1.4, -0.4}, {1.5, -1.1, 1.6}};
  const Eigen::VectorXd v = random_vector(12);
  const auto moved = [&](double t) {
    HingeCorners x = flat;
    for (int c = 0; c < 4; ++c) x[c] += t * v.segment<3>(3 * c);
    return x;
  };
  const Hinge at = hinge(flat);
  EXPECT_EQ(at.gradient, hinge_slope(flat));
  EXPECT_GT(std::abs(at.angle), 0.3);
  EXPECT_LE((at.hessian - at.hessian.transpose()).norm(), 1e-14);
  expect_order([&](double t) { return std::abs(hinge_angle(moved(t)) - at.angle - t * at.gradient.dot(v)); }, 1e-3, 2,
               1e-15);
  expect_order([&](double t) { return (hinge_slope(moved(t)) - at.gradient - t * at.hessian * v).norm(); }, 1e-3, 2,
               1e-15);
}

TEST(Hinge, IsPositiveWhereTheSurfaceIsConvex) {
  // Seen from +z: a ridge along x, its sides falling by 0.3 and 0.5.
  const HingeCorners ridge{
      Eigen::Vector3d(0, 0, 0), {1, 0, 0}, {0.5, std::cos(0.3), -std::sin(0.3)}, {0.5, -std::cos(0.5), -std::sin(0.5)}};
  EXPECT_NEAR(hinge_angle(ridge), 0.8, 1e-15);
}

TEST(Bending, GradientAndHessianAreThoseOfTheEnergy) {
  const PlateMesh mesh = irregular_disc(10, 3);
  const auto mixed = [](int a, int b) { return (a + b) % 2 == 0 ? SlopeSupport::held : SlopeSupport::free; };
  const Bending bending(mesh.nodes, mesh.triangles, moduli, mixed);
  Shape at(mesh, bending, [](const Eigen::Vector2d& x) {
    return Eigen::Vector3d(0.9 * x[0], x[1] + 0.02 * x[0] * x[0], 0.06 * x[0] * x[0] - 0.03 * x[0] * x[1] + 0.2 * x[1]);
  });
  at.rotations = 0.1 * random_vector(at.rotations.size());
  const Eigen::Index n = at.u.size();
  const Eigen::VectorXd v = random_vector(n + at.rotations.size());
  const auto gradient = [&](double t, double& energy) {
    Shape moved = at;
    moved.u += t * v.head(n);
    moved.rotations += t * v.tail(v.size() - n);
    Eigen::VectorXd g = Eigen::VectorXd::Zero(v.size());
    Eigen::VectorXd by_u = Eigen::VectorXd::Zero(n);
    Eigen::VectorXd by_r = Eigen::VectorXd::Zero(v.size() - n);
    energy = bending.add_gradient(moved.u, moved.rotations, by_u, by_r);
    g << by_u, by_r;
    return g;
  };
  double energy = 0;
  double other = 0;
  const Eigen::VectorXd g = gradient(0, energy);
  Eigen::SparseMatrix<double> K = hessian_of(bending, at);
  for (int r = 0; r < bending.rotation_count(); ++r)
    if (bending.rotation_is_held(r)) K.coeffRef(n + r, n + r) = 0;
  expect_order(
      [&](double t) {
        gradient(t, other);
        return std::abs(other - energy - t * g.dot(v));
      },
      1e-3, 2, 1e-13 * energy);
  expect_order([&](double t) { return (gradient(t, other) - g - t * (K * v)).norm(); }, 1e-3, 2, 1e-13 * K.norm());
}

TEST(Bending, RigidMotionsAreFree) {
  const PlateMesh mesh = irregular_disc(10, 4);
  const Bending bending = bending_of(mesh, free_edge);
  const Eigen::Matrix3d R = Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, -0.4, 0.7).normalized()).toRotationMatrix();
  const Shape at(mesh, bending, [&](const Eigen::Vector2d& x) {
    return Eigen::Vector3d(R * Eigen::Vector3d(x[0], x[1], 0) + Eigen::Vector3d(3, -2, 8));
  });
  EXPECT_NEAR(energy_of(bending, at), 0, 1e-24);
}

/// Tilt of an edge's normal on a surface of small slope against the middle between its triangles.
template <class Slope>
double tilt(const PlateMesh& mesh, std::array<int, 2> ends, const Eigen::VectorXd& u, Slope slope) {
  const Eigen::Vector2d along = mesh.nodes[ends[1]] - mesh.nodes[ends[0]];
  const Eigen::Vector2d outward = Eigen::Vector2d(along[1], -along[0]).normalized();
  Eigen::Vector2d flat = Eigen::Vector2d::Zero();
  int triangles = 0;
  for (const auto& t : mesh.triangles) {
    if (std::count(t.begin(), t.end(), ends[0]) + std::count(t.begin(), t.end(), ends[1]) < 2) continue;
    Eigen::Matrix2d edges;
    edges << (mesh.nodes[t[1]] - mesh.nodes[t[0]]).transpose(), (mesh.nodes[t[2]] - mesh.nodes[t[0]]).transpose();
    flat += edges.inverse() * Eigen::Vector2d(u[3 * t[1] + 2] - u[3 * t[0] + 2], u[3 * t[2] + 2] - u[3 * t[0] + 2]);
    ++triangles;
  }
  return -(slope((mesh.nodes[ends[0]] + mesh.nodes[ends[1]]) / 2) - flat / triangles).dot(outward);
}

// Constant curvature on an irregular mesh: any combination, with the energy of its invariants.
TEST(Bending, ConstantCurvatureIsExactOnAnyMesh) {
  const PlateMesh mesh = irregular_disc(10, 5);
  const Bending bending = bending_of(mesh, free_edge);
  double area = 0;
  for (const auto& t : mesh.triangles) area += twice_area(mesh, t) / 2;
  const double small = 1e-5;
  for (const auto& [a, b, c] : {std::tuple{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, {0.7, -1.3, 0.4}}) {
    const Shape at(mesh, bending, [&, a = a, b = b, c = c](const Eigen::Vector2d& x) {
      return Eigen::Vector3d(x[0], x[1], small * (a * x[0] * x[0] / 2 + b * x[1] * x[1] / 2 + c * x[0] * x[1]));
    });
    const double exact =
        area * small * small * (moduli.mean_eV / 2 * (a + b) * (a + b) + moduli.gaussian_eV * (a * b - c * c));
    Shape exact_shape = at;
    const auto slope = [&, a = a, b = b, c = c](const Eigen::Vector2d& x) {
      return Eigen::Vector2d(small * (a * x[0] + c * x[1]), small * (b * x[1] + c * x[0]));
    };
    for (int e = 0; e < bending.rotation_count(); ++e)
      exact_shape.rotations[e] = tilt(mesh, bending.ends(e), at.u, slope);
    EXPECT_NEAR(energy_of(bending, exact_shape) / exact, 1, 1e-8);
  }
}

/// Depth of node 0 at small deflection under nodal loads of unit total, uniform over r <= c (0: on node 0).
/// Nodes of the boundary are clamped.
double clamped_plate(const PlateMesh& mesh, double c) {
  const Bending bending = bending_of(mesh, held, clamped_all_round(moduli.mean_eV));
  const Shape flat(mesh, bending, [](const Eigen::Vector2d& x) { return Eigen::Vector3d(x[0], x[1], 0); });
  const Eigen::SparseMatrix<double> K = hessian_of(bending, flat);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(K.rows());
  if (c == 0) load[2] = 1;
  for (const auto& t : mesh.triangles)
    if (c > 0 && ((mesh.nodes[t[0]] + mesh.nodes[t[1]] + mesh.nodes[t[2]]) / 3).norm() < c)
      for (int n : t) load[3 * n + 2] += twice_area(mesh, t) / 6;
  load /= load.sum();
  std::vector<bool> prescribed(K.rows(), false);
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    for (int k = 0; k < 3; ++k) prescribed[3 * n + k] = mesh.boundary[n] || k < 2;
  return solve_free(K, load, prescribed)[2];
}

// Second order, on regular meshes and on irregular ones. Point: F = 16 π κ δ/a². Disc: Timoshenko &
// Woinowsky-Krieger, Theory of Plates and Shells, art. 19.
TEST(Bending, ClampedPlateConverges) {
  const double a = 10;
  const double kappa = moduli.mean_eV;
  for (double c : {0.0, a}) {
    const double exact =
        c == 0 ? a * a / (16 * pi * kappa) : (4 * a * a - 4 * c * c * std::log(a / c) - 3 * c * c) / (64 * pi * kappa);
    const auto error = [&](auto make, int rings) {
      const double excess = clamped_plate(make(a, rings), c) / exact - 1;
      std::cout << "clamped plate, load on " << c / a << " a, " << 6 * rings * rings << " triangles: " << excess
                << '\n';
      return excess;
    };
    const double regular = error(hexagonal_disc, 40);
    EXPECT_NEAR(std::log2(error(hexagonal_disc, 20) / regular), c == 0 ? 1.75 : 2,
                0.1);  // h² ln h under a point
    EXPECT_LE(std::abs(regular), 0.003);
    // Irregular meshes do not follow from each other by halving: about the same order.
    const double irregular = error(irregular_disc, 40);
    EXPECT_NEAR(std::log2(error(irregular_disc, 20) / irregular), 1.9, 0.3);
    EXPECT_LE(std::abs(irregular), c == 0 ? 0.015 : 0.005);
  }
}

// Clamped square under a uniform load, one quarter between its symmetry planes: w = 0.00126532 q (2 L)⁴/κ
// (Taylor & Govindjee, Commun. Numer. Meth. Eng. 20 (2004) 757).
TEST(Bending, HeldEdgesAreSymmetryPlanesToo) {
  const double L = 5;
  const auto error = [&](int columns) {
    PlateMesh mesh = rectangle_mesh(L, L, columns, columns);
    jitter(mesh, 0.2 * L / columns);
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
      mesh.boundary[n] = mesh.nodes[n][0] == L || mesh.nodes[n][1] == L;
    const double depth = clamped_plate(mesh, 100 * L);
    return depth * 4 * L * L / (4 * 0.00126532 * std::pow(2 * L, 4) / moduli.mean_eV) - 1;
  };
  const double coarse = error(10);
  const double fine = error(20);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.3);
  EXPECT_LE(std::abs(fine), 0.02);
}

}  // namespace
}  // namespace membrane::testing
