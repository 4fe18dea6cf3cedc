// A triangulated flat sheet with its boundary: what energies and loads need to know of a shape.
#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <vector>

namespace membrane {

enum class Edge { rim, hub, left, right, bottom, top };

/// How an edge is held. Sliding: it stays in its plane z = 0 and is free in it.
enum class Support { clamped, sliding, free };

/// Reference geometry of a triangle in the plane.
struct Triangle {
  std::array<int, 3> nodes{};
  double area_A2 = 0;
  Eigen::Matrix<double, 2, 3> shape_gradients;  ///< column a: gradient of the shape function of node a, 1/Å
};

/// Per node and component: whether the degree of freedom is prescribed.
using Held = std::vector<std::array<bool, 3>>;

/// Nodes on one circle about the origin, consecutive and at even angles.
struct NodeRing {
  double radius_A = 0;
  int first = 0, count = 0;
  bool closed = false;  ///< goes all the way round; otherwise it ends on symmetry planes
};

/// Nodes in the plane z = 0 and triangles over them. Degree of freedom 3 n + c is component c of node n.
struct Mesh {
  std::vector<Eigen::Vector2d> nodes;  ///< Å
  std::vector<Triangle> triangles;     ///< counter-clockwise
  Held held;                           ///< per node and component: the displacement is prescribed
  std::map<Edge, std::vector<int>> edges;
  std::map<Edge, Support> supports;               ///< of the edges that support() was told of
  std::vector<NodeRing> rings;                    ///< of a round sheet, outwards; else empty
  std::vector<int> rim_triangles;                 ///< triangles with an edge on the rim of a round sheet
  std::array<bool, 2> mirrored = {false, false};  ///< x = 0, y = 0 are symmetry planes of the full sheet
  int copies = 1;                                 ///< the full sheet consists of this many of the meshed part

  int node_count() const { return static_cast<int>(nodes.size()); }
  double area_A2() const;

  /// Holds the nodes of an edge as its support asks for, in addition to what holds them already.
  void support(Edge edge, Support support);

  /// Whether an edge is held in its plane alone.
  bool slides(Edge edge) const;
};

/// Triangle over three nodes of the plane. Throws std::invalid_argument if it is degenerate or turned over.
Triangle make_triangle(const std::vector<Eigen::Vector2d>& nodes, const std::array<int, 3>& corners);

/// The boundary sides of the edges that are held in their plane alone, as the sheet lies to their left.
std::vector<std::array<int, 2>> sliding_sides(const Mesh& mesh);

/// Weights over the nodes (length: node count, total 1) whose dot product with a nodal field is its mean over the angle
/// at radius r: on a ring of nodes exactly, between two rings linear in r. At r = 0, and where there are no rings, the
/// node nearest to the origin.
Eigen::VectorXd mean_on_circle(const Mesh& mesh, double radius_A);

}  // namespace membrane
