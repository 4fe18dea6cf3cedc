// Bending and stretching together at large displacements: cylinder, elastica, the crossover from plate to
// membrane.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <numbers>

#include "membrane/bending/bending.hpp"
#include "membrane/problem.hpp"
#include "plate_meshes.hpp"
#include "plate_solver.hpp"

namespace membrane::testing {
namespace {

using std::numbers::pi;

SlopeSupport held(int, int) { return SlopeSupport::held; }
SlopeSupport free_edge(int, int) { return SlopeSupport::free; }

// A strip rolled to half a cylinder, on an irregular mesh. κG = −κ leaves its straight sides without moment.
TEST(BendingSheet, CylinderHasTheEnergyOfItsCurvature) {
  const double length = 10;
  const double width = 6;
  const double R = length / pi;
  const auto error = [&](int columns) {
    const double h = length / columns;
    PlateMesh mesh = rectangle_mesh(length, width, columns, columns * 3 / 5);
    jitter(mesh, 0.2 * h);
    flip_edges(mesh, 0.3 * h * h);
    const Bending bending(mesh.nodes, mesh.triangles, {2, -2}, free_edge);
    Shape at(mesh, bending, [&](const Eigen::Vector2d& x) {
      return Eigen::Vector3d(R * std::sin(x[0] / R), x[1], R * (1 - std::cos(x[0] / R)));
    });
    // The ends are bent by the surface's own slope, against a triangle's that reaches one element inside.
    std::vector<bool> prescribed(3 * mesh.nodes.size() + bending.rotation_count(), false);
    std::fill_n(prescribed.begin(), 3 * mesh.nodes.size(), true);
    for (int e = 0; e < bending.rotation_count(); ++e) {
      const auto [a, b] = bending.ends(e);
      const double x = mesh.nodes[a][0];
      if (mesh.nodes[b][0] != x || (x != 0 && x != length)) continue;
      for (const auto& t : mesh.triangles)
        for (int i = 0; i < 3; ++i)
          if (t[(i + 1) % 3] == a && t[(i + 2) % 3] == b)
            at.rotations[e] = -std::abs(mesh.nodes[t[i]][0] - x) / (2 * R);
      prescribed[3 * mesh.nodes.size() + e] = true;
    }
    Eigen::VectorXd by_u = Eigen::VectorXd::Zero(at.u.size());
    Eigen::VectorXd by_rotations = Eigen::VectorXd::Zero(at.rotations.size());
    bending.add_gradient(at.u, at.rotations, by_u, by_rotations);
    Eigen::VectorXd load(at.u.size() + at.rotations.size());
    load << by_u, -by_rotations;
    at.rotations += solve_free(hessian_of(bending, at), load, prescribed).tail(at.rotations.size());
    return energy_of(bending, at) / (0.5 * 2 * length * width / (R * R)) - 1;
  };
  const double coarse = error(20);
  const double fine = error(40);
  std::cout << "cylinder: " << coarse << ", " << fine << '\n';
  EXPECT_LE(std::abs(fine), 0.005);
  EXPECT_GT(std::abs(coarse / fine), 3);
}

// Cantilever of flexural stiffness EI under an end force P across it: tip displacements over its length
// (Mattiasson, Int. J. Numer. Meth. Eng. 17 (1981) 145).
TEST(BendingSheet, CantileverIsTheElastica) {
  const double L = 10;
  const double B = 2;
  const double kappa = 1;
  PlateMesh mesh = rectangle_mesh(L, B, 40, 8);
  jitter(mesh, 0.05);
  const auto clamped_end = [&](int a, int b) {
    return mesh.nodes[a][0] == 0 && mesh.nodes[b][0] == 0 ? SlopeSupport::held : SlopeSupport::free;
  };
  const Bending bending(mesh.nodes, mesh.triangles, {kappa, -kappa}, clamped_end);
  std::vector<bool> prescribed(3 * mesh.nodes.size() + bending.rotation_count(), false);
  for (int e = 0; e < bending.rotation_count(); ++e)
    prescribed[3 * mesh.nodes.size() + e] = bending.rotation_is_held(e);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(prescribed.size()));
  int tip = 0;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const bool corner = mesh.nodes[n][1] == 0 || mesh.nodes[n][1] == B;
    if (mesh.nodes[n][0] == 0) std::fill_n(prescribed.begin() + 3 * n, 3, true);
    if (mesh.nodes[n][0] == L) load[3 * n + 2] = corner ? 1 : 2;
    if (mesh.nodes[n][0] == L && mesh.nodes[n][1] == B / 2) tip = static_cast<int>(n);
  }
  load *= kappa * B / (L * L) / load.sum();  // P L²/EI = 1
  const PlateSolver solver(mesh, bending, {1e4 * kappa / (L * L), 0}, prescribed);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(load.size());
  for (const auto& [force, across, along] :
       {std::tuple{1.0, 0.30172, 0.05643}, {2.0, 0.49346, 0.16064}, {3.0, 0.60325, 0.25442}, {5.0, 0.71379, 0.38763}}) {
    x = solver.solve(force * load, x);
    std::cout << "elastica " << force << ": " << x[3 * tip + 2] / L / across - 1 << ' ' << -x[3 * tip] / L / along - 1
              << '\n';
    EXPECT_NEAR(x[3 * tip + 2] / L, across, 0.005 * across);
    EXPECT_NEAR(-x[3 * tip] / L, along, 0.005 * along);
  }
}

// A clamped disc under a disc load where bending and stretching weigh about the same, against the
// one-dimensional sheet.
TEST(BendingSheet, CrossoverFromPlateToMembrane) {
  const double a = 10;
  const double c = 5;
  const StVenantKirchhoff law{20, 0.3};
  const double kappa = 0.01;
  const double force = 0.008;
  Problem problem;
  problem.discretisation = Meridian{};
  problem.sheet = DiscSheet{a};
  problem.law = law;
  problem.relaxed = false;
  problem.bending = clamped_all_round(kappa);
  problem.load = DiscLoad{c};
  problem.control = Control::force;
  problem.levels = {force};
  double exact = 0;
  solve(problem, [&](const Step& step) {
    EXPECT_GT(step.bending_energy_eV, 0.3 * step.energy_eV);
    EXPECT_LT(step.bending_energy_eV, 0.7 * step.energy_eV);
    exact = step.depth_A;
    return true;
  });
  const auto error = [&](int rings) {
    const PlateMesh mesh = hexagonal_disc(a, rings);
    const Bending bending(mesh.nodes, mesh.triangles, clamped_all_round(kappa), held);
    std::vector<bool> prescribed(3 * mesh.nodes.size() + bending.rotation_count(), false);
    for (int e = 0; e < bending.rotation_count(); ++e)
      prescribed[3 * mesh.nodes.size() + e] = bending.rotation_is_held(e);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(prescribed.size()));
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
      if (mesh.boundary[n]) std::fill_n(prescribed.begin() + 3 * n, 3, true);
    for (const auto& t : mesh.triangles)
      if (((mesh.nodes[t[0]] + mesh.nodes[t[1]] + mesh.nodes[t[2]]) / 3).norm() < c)
        for (int n : t) load[3 * n + 2] += twice_area(mesh, t) / 6;
    load *= force / load.sum();
    const PlateSolver solver(mesh, bending, law, prescribed);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(load.size());
    for (double share : {0.3, 1.0}) x = solver.solve(share * load, x);
    const double excess = x[2] / exact - 1;
    std::cout << "crossover, depth/a " << exact / a << ", " << mesh.triangles.size() << " triangles: " << excess
              << '\n';
    return excess;
  };
  const double coarse = error(8);
  const double fine = error(16);
  EXPECT_LE(std::abs(fine), 0.005);
  EXPECT_NEAR(std::log2(std::abs(coarse / fine)), 2, 0.3);
}

}  // namespace
}  // namespace membrane::testing
