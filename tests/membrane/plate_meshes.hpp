// Meshes to try bending on: regular, jittered, and with edges flipped at random.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <vector>

namespace membrane::testing {

struct PlateMesh {
  std::vector<Eigen::Vector2d> nodes;
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise
  std::vector<bool> boundary;                 ///< per node
};

inline double twice_area(const PlateMesh& mesh, const std::array<int, 3>& t) {
  const Eigen::Vector2d a = mesh.nodes[t[1]] - mesh.nodes[t[0]];
  const Eigen::Vector2d b = mesh.nodes[t[2]] - mesh.nodes[t[0]];
  return a[0] * b[1] - a[1] * b[0];
}

/// A full disc of this radius: ring i holds 6 i nodes.
inline PlateMesh hexagonal_disc(double radius, int rings) {
  PlateMesh mesh;
  mesh.nodes.push_back({0, 0});
  const auto node = [](int ring, int k) { return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1) + k % (6 * ring); };
  for (int i = 1; i <= rings; ++i)
    for (int k = 0; k < 6 * i; ++k) {
      const double angle = 2 * std::numbers::pi * k / (6 * i);
      mesh.nodes.push_back(radius * i / rings * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
  for (int i = 1; i <= rings; ++i)
    for (int sector = 0; sector < 6; ++sector)
      for (int k = 0; k < i; ++k) {
        const int out = sector * i + k;
        const int in = sector * (i - 1) + k;
        mesh.triangles.push_back({node(i - 1, in), node(i, out), node(i, out + 1)});
        if (k + 1 < i) mesh.triangles.push_back({node(i - 1, in), node(i, out + 1), node(i - 1, in + 1)});
      }
  mesh.boundary.assign(mesh.nodes.size(), false);
  for (int k = 0; k < 6 * rings; ++k) mesh.boundary[node(rings, k)] = true;
  return mesh;
}

/// [0, length] × [0, width], all diagonals in one direction.
inline PlateMesh rectangle_mesh(double length, double width, int columns, int rows) {
  PlateMesh mesh;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      mesh.nodes.push_back({length * i / columns, width * j / rows});
      mesh.boundary.push_back(i == 0 || j == 0 || i == columns || j == rows);
    }
  const auto node = [&](int i, int j) { return j * (columns + 1) + i; };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      mesh.triangles.push_back({node(i, j), node(i + 1, j), node(i + 1, j + 1)});
      mesh.triangles.push_back({node(i, j), node(i + 1, j + 1), node(i, j + 1)});
    }
  return mesh;
}

/// Moves the nodes inside by up to a length each way.
inline void jitter(PlateMesh& mesh, double length) {
  std::mt19937 random(20100407);
  std::uniform_real_distribution<double> any(-length, length);
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    if (!mesh.boundary[n]) mesh.nodes[n] += Eigen::Vector2d(any(random), any(random));
}

/// Turns about a third of the inner edges over to the other diagonal where both triangles stay well shaped.
inline void flip_edges(PlateMesh& mesh, double least_twice_area) {
  std::mt19937 random(20100407);
  std::vector<bool> touched(mesh.triangles.size(), false);
  std::map<std::pair<int, int>, std::pair<int, int>> started;  // directed edge -> (triangle, third corner)
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const auto& n = mesh.triangles[t];
      started[{n[i], n[(i + 1) % 3]}] = {static_cast<int>(t), n[(i + 2) % 3]};
    }
  for (const auto& [edge, one] : started) {
    const auto other = started.find({edge.second, edge.first});
    if (other == started.end() || edge.first > edge.second || random() % 2 == 0) continue;
    const auto [t, c] = one;
    const auto [s, d] = other->second;
    if (touched[t] || touched[s]) continue;
    const std::array<int, 3> left{edge.first, d, c};
    const std::array<int, 3> right{edge.second, c, d};
    if (twice_area(mesh, left) < least_twice_area || twice_area(mesh, right) < least_twice_area) continue;
    mesh.triangles[t] = left;
    mesh.triangles[s] = right;
    touched[t] = touched[s] = true;
  }
}

}  // namespace membrane::testing
