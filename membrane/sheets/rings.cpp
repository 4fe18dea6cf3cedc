#include "membrane/sheets/rings.hpp"

#include <cmath>
#include <numbers>

namespace membrane {
namespace {

using std::numbers::pi;

/// Adds a ring of nodes that starts on the x axis. On symmetry planes the coordinate is exactly 0 and held.
void add_ring(double radius, int segments, double turn, bool closed, Mesh& mesh) {
  const int count = closed ? segments : segments + 1;
  mesh.rings.push_back({radius, mesh.node_count(), count, closed});
  for (int k = 0; k < count; ++k) {
    const bool on_x_axis = !closed && k == 0;
    const bool on_y_axis = !closed && k == segments;
    const double angle = turn * k / segments;
    mesh.nodes.emplace_back(on_y_axis ? 0 : radius * std::cos(angle), on_x_axis ? 0 : radius * std::sin(angle));
    mesh.held.push_back({on_y_axis, on_x_axis, false});
  }
}

int node_at(const NodeRing& ring, int position) {
  return ring.first + (ring.closed ? position % ring.count : position);
}

/// Triangles of one sector between the ring inside with `inner_segments` = i − 1 of them and the one outside with i.
void add_sector(const Mesh& mesh, int ring, int sector, std::vector<std::array<int, 3>>& corners) {
  const NodeRing& inside = mesh.rings[ring - 1];
  const NodeRing& outside = mesh.rings[ring];
  for (int k = 0; k < ring; ++k) {
    const int inner = ring == 1 ? inside.first : node_at(inside, sector * (ring - 1) + k);
    const int outer = node_at(outside, sector * ring + k), next = node_at(outside, sector * ring + k + 1);
    corners.push_back({inner, outer, next});
    if (k + 1 < ring) corners.push_back({inner, next, node_at(inside, sector * (ring - 1) + k + 1)});
  }
}

void list_ring_nodes(Edge edge, const NodeRing& ring, Mesh& mesh) {
  for (int k = 0; k < ring.count; ++k) mesh.edges[edge].push_back(ring.first + k);
}

}  // namespace

Mesh disc_mesh(const std::vector<double>& radii_A, Extent extent) {
  const bool closed = extent == Extent::full;
  const int sectors = closed ? 6 : 1;
  Mesh mesh;
  mesh.copies = closed ? 1 : 4;
  mesh.mirrored = {!closed, !closed};
  mesh.nodes.emplace_back(0, 0);
  mesh.held.push_back({!closed, !closed, false});
  mesh.rings.push_back({0, 0, 1, closed});
  const int rings = static_cast<int>(radii_A.size()) - 1;
  for (int ring = 1; ring <= rings; ++ring) {
    add_ring(radii_A[ring], sectors * ring, closed ? 2 * pi : pi / 2, closed, mesh);
    std::vector<std::array<int, 3>> corners;
    for (int sector = 0; sector < sectors; ++sector) add_sector(mesh, ring, sector, corners);
    for (const auto& triangle : corners) {
      if (ring == rings && triangle[1] >= mesh.rings[ring].first && triangle[2] >= mesh.rings[ring].first)
        mesh.rim_triangles.push_back(static_cast<int>(mesh.triangles.size()));
      mesh.triangles.push_back(make_triangle(mesh.nodes, triangle));
    }
  }
  list_ring_nodes(Edge::rim, mesh.rings.back(), mesh);
  return mesh;
}

Mesh annulus_mesh(double hub_radius_A, double radius_A, int rings, int around) {
  Mesh mesh;
  for (int ring = 0; ring <= rings; ++ring) {
    const double radius = ring == rings ? radius_A : hub_radius_A + (radius_A - hub_radius_A) * ring / rings;
    add_ring(radius, around, 2 * pi, true, mesh);
    if (ring == 0) continue;
    for (int k = 0; k < around; ++k) {
      const int a = node_at(mesh.rings[ring - 1], k), b = node_at(mesh.rings[ring], k);
      const int c = node_at(mesh.rings[ring], k + 1), d = node_at(mesh.rings[ring - 1], k + 1);
      if (ring == rings) mesh.rim_triangles.push_back(static_cast<int>(mesh.triangles.size()) + (ring + k) % 2);
      if ((ring + k) % 2 == 0) {
        mesh.triangles.push_back(make_triangle(mesh.nodes, {b, c, a}));
        mesh.triangles.push_back(make_triangle(mesh.nodes, {a, c, d}));
      } else {
        mesh.triangles.push_back(make_triangle(mesh.nodes, {a, b, d}));
        mesh.triangles.push_back(make_triangle(mesh.nodes, {b, c, d}));
      }
    }
  }
  list_ring_nodes(Edge::hub, mesh.rings.front(), mesh);
  list_ring_nodes(Edge::rim, mesh.rings.back(), mesh);
  return mesh;
}

}  // namespace membrane
