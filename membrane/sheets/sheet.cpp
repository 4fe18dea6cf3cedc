#include "membrane/sheets/sheet.hpp"

#include <algorithm>
#include <cmath>

#include "membrane/base/refusal.hpp"
#include "membrane/sheets/grading.hpp"
#include "membrane/sheets/rectangle.hpp"
#include "membrane/sheets/rings.hpp"

namespace membrane {
namespace {

constexpr int most_rings = 2000;
constexpr int most_cells = 4000;

void check_length(const char* name, double length) {
  if (!(length > 0) || !std::isfinite(length)) refuse(name, length, "must be positive and finite");
}

void check_count(const char* name, int count, int fewest, int most) {
  if (count < fewest || count > most)
    refuse(name, count, "must lie between " + std::to_string(fewest) + " and " + std::to_string(most));
}

struct Check {
  void operator()(const DiscSheet& disc) const {
    check_length("sheet.radius_A", disc.radius_A);
    check_count("sheet.rings", disc.rings, fewest_rings, most_rings);
    if (disc.rim == Support::free) refuse("sheet.rim", "free", "a disc must be held at its rim: clamped or sliding");
    if (!(disc.slope_margin_A >= 0 && disc.slope_margin_A < disc.radius_A))
      refuse("sheet.slope_margin_A", disc.slope_margin_A, "must be at least 0 and below sheet.radius_A");
  }
  void operator()(const AnnulusSheet& ring) const {
    check_length("sheet.radius_A", ring.radius_A);
    check_length("sheet.hub_radius_A", ring.hub_radius_A);
    if (!(ring.hub_radius_A < ring.radius_A))
      refuse("sheet.hub_radius_A", ring.hub_radius_A, "must be smaller than sheet.radius_A");
    check_count("sheet.rings", ring.rings, 1, most_rings);
    check_count("sheet.around", ring.around, 8, 4 * most_cells);
    if (ring.hub != Support::clamped && ring.rim != Support::clamped)
      refuse("sheet.hub", "not clamped", "hub or rim must be clamped, or the sheet can turn in its plane");
  }
  void operator()(const RectangleSheet& r) const {
    check_length("sheet.length_x_A", r.length_x_A);
    check_length("sheet.length_y_A", r.length_y_A);
    check_count("sheet.cells_x", r.cells_x, 1, most_cells);
    check_count("sheet.cells_y", r.cells_y, 1, most_cells);
    if (!(r.edge_grading >= 1 && r.edge_grading <= 1000))
      refuse("sheet.edge_grading", r.edge_grading, "must lie between 1 and 1000");
    const bool quarter = r.extent == Extent::quarter;
    if (quarter && (r.left != r.right || r.bottom != r.top))
      refuse("sheet.extent", "quarter", "opposite edges must be held alike: left and right, bottom and top");
    if (!quarter) return;
    const auto holds = [](Support support) { return support != Support::free; };
    if (!holds(r.right) && !holds(r.top)) refuse("sheet.right", "free", "some edge must be held: clamped or sliding");
  }
};

struct MeshOf {
  const MeshDemand& demand;
  Mesh operator()(const DiscSheet& disc) const {
    const RingDemand rings{disc.radius_A, demand.load_radius_A, demand.record_radius_A,
                           disc.rings,    demand.layer_A,       demand.at_point};
    Mesh mesh =
        disc_mesh(disc.spacing == RingSpacing::graded ? graded_radii(rings) : uniform_radii(rings), disc.extent);
    mesh.support(Edge::rim, disc.rim);
    if (disc.extent == Extent::full && disc.rim == Support::sliding)
      mesh.held.front()[0] = mesh.held.front()[1] =
          true;  // loads that balance themselves leave the centre without force
    return mesh;
  }
  Mesh operator()(const AnnulusSheet& ring) const {
    Mesh mesh = annulus_mesh(ring.hub_radius_A, ring.radius_A, ring.rings, ring.around);
    mesh.support(Edge::hub, ring.hub);
    mesh.support(Edge::rim, ring.rim);
    return mesh;
  }
  Mesh operator()(const RectangleSheet& r) const {
    Mesh mesh = rectangle_mesh(r);
    for (const auto& [edge, support] : {std::pair{Edge::left, r.left}, std::pair{Edge::right, r.right},
                                        std::pair{Edge::bottom, r.bottom}, std::pair{Edge::top, r.top}})
      if (mesh.edges.contains(edge)) mesh.support(edge, support);
    return mesh;
  }
};

struct SupportsOf {
  using List = std::vector<std::pair<Edge, Support>>;
  List operator()(const DiscSheet& s) const { return {{Edge::rim, s.rim}}; }
  List operator()(const AnnulusSheet& s) const { return {{Edge::hub, s.hub}, {Edge::rim, s.rim}}; }
  List operator()(const RectangleSheet& s) const {
    if (s.extent == Extent::quarter) return {{Edge::right, s.right}, {Edge::top, s.top}};
    return {{Edge::left, s.left}, {Edge::right, s.right}, {Edge::bottom, s.bottom}, {Edge::top, s.top}};
  }
};

struct IsQuarter {
  bool operator()(const DiscSheet& s) const { return s.extent == Extent::quarter; }
  bool operator()(const AnnulusSheet&) const { return false; }
  bool operator()(const RectangleSheet& s) const { return s.extent == Extent::quarter; }
};

struct InnerRadius {
  double operator()(const DiscSheet& s) const { return s.radius_A; }
  double operator()(const AnnulusSheet& s) const { return s.radius_A; }
  double operator()(const RectangleSheet& s) const { return 0.5 * std::min(s.length_x_A, s.length_y_A); }
};

}  // namespace

DiscSheet paper_disc(double radius_A) { return {.radius_A = radius_A, .rings = 44, .spacing = RingSpacing::uniform}; }

RectangleSheet paper_square(double side_A) {
  return {.length_x_A = side_A, .length_y_A = side_A, .cells_x = 60, .cells_y = 60, .extent = Extent::full};
}

void check(const Sheet& sheet) { std::visit(Check{}, sheet); }

Mesh make_mesh(const Sheet& sheet, const MeshDemand& demand) { return std::visit(MeshOf{demand}, sheet); }

std::vector<std::pair<Edge, Support>> supports_of(const Sheet& sheet) { return std::visit(SupportsOf{}, sheet); }

bool is_quarter(const Sheet& sheet) { return std::visit(IsQuarter{}, sheet); }

double inner_radius_A(const Sheet& sheet) { return std::visit(InnerRadius{}, sheet); }

}  // namespace membrane
