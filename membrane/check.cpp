// What makes a problem unsolvable before anything is computed.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "membrane/base/refusal.hpp"
#include "membrane/laws/principal.hpp"
#include "membrane/problem.hpp"

namespace membrane {
namespace {

constexpr double widest_load = 0.98;  // of the sheet: there must be room for a ring of triangles outside

bool positive(double x) { return x > 0 && std::isfinite(x); }

bool is_disc(const Sheet& sheet) { return std::holds_alternative<DiscSheet>(sheet); }

/// Every edge of a sheet with its support.
struct SupportsOf {
  using List = std::vector<std::pair<Edge, Support>>;
  List operator()(const DiscSheet& s) const { return {{Edge::rim, s.rim}}; }
  List operator()(const AnnulusSheet& s) const { return {{Edge::hub, s.hub}, {Edge::rim, s.rim}}; }
  List operator()(const RectangleSheet& s) const {
    if (s.extent == Extent::quarter) return {{Edge::right, s.right}, {Edge::top, s.top}};
    return {{Edge::left, s.left}, {Edge::right, s.right}, {Edge::bottom, s.bottom}, {Edge::top, s.top}};
  }
};

bool holds(Support support) { return support != Support::free; }

/// A load across a sheet needs supports across it.
void check_held(const Problem& problem) {
  for (const auto& [edge, support] : std::visit(SupportsOf{}, problem.sheet))
    if (holds(support)) return;
  refuse("sheet", "free edges", "some edge must be held, clamped or sliding: nothing bears the load");
}

/// Edges that end in each other's corners.
bool meet(Edge a, Edge b) {
  const auto upright = [](Edge e) { return e == Edge::left || e == Edge::right; };
  const auto lying = [](Edge e) { return e == Edge::bottom || e == Edge::top; };
  return (upright(a) && lying(b)) || (lying(a) && upright(b));
}

/// A node cannot move with one edge and stay with another, or in a symmetry plane that the motion leaves.
void check_corners(const Problem& problem, const EdgeMotion& motion) {
  const bool turns = motion.rotation_rad != 0;
  const bool in_plane = turns || motion.translation_A.head<2>().norm() > 0, across = motion.translation_A.z() != 0;
  for (const auto& [edge, support] : std::visit(SupportsOf{}, problem.sheet))
    if (meet(edge, motion.edge) && (support == Support::clamped || (support == Support::sliding && across)))
      refuse("load.edge", int(motion.edge),
             "it meets an edge that stays: its corner cannot do both; let that edge be free");
  const auto* rectangle = std::get_if<RectangleSheet>(&problem.sheet);
  const auto* disc = std::get_if<DiscSheet>(&problem.sheet);
  if (disc && disc->extent == Extent::quarter && in_plane)
    refuse("load.translation_A", motion.translation_A.transpose(),
           "a quarter's rim moves out of its symmetry planes: mesh the full sheet");
  if (!rectangle || rectangle->extent == Extent::full) return;
  const double along = motion.edge == Edge::right ? motion.translation_A.y() : motion.translation_A.x();
  if (turns || along != 0)
    refuse("load.translation_A", motion.translation_A.transpose(),
           "a quarter's edge moves out of its symmetry plane: mesh the full sheet");
}

void check_closed(const Problem& problem, const char* member) {
  for (const auto& [edge, support] : std::visit(SupportsOf{}, problem.sheet))
    if (support == Support::free)
      refuse(member, "a pressure",
             "a sheet under pressure needs every edge in its plane: clamped or sliding, not free");
}

struct CheckLoad {
  const Problem& problem;

  void operator()(const PointLoad&) const { has_centre(); }
  void operator()(const DiscLoad& disc) const {
    has_centre();
    fits(disc.radius_A);
  }
  void operator()(const RadialLoad& load) const {
    has_centre();
    const auto& [radii, density] = load;
    if (radii.empty() || radii.size() != density.size())
      refuse("load.density", density.size(), "must have as many entries as load.radius_A, at least one");
    if (!(radii.front() >= 0) || !std::is_sorted(radii.begin(), radii.end(), std::less_equal<>{}))
      refuse("load.radius_A", radii.front(), "must rise from 0 or more");
    for (double value : density)
      if (!(value >= 0 && std::isfinite(value))) refuse("load.density", value, "must be finite and not negative");
    fits(radii.back());
  }
  void operator()(const SphereLoad& sphere) const {
    has_centre();
    if (!is_disc(problem.sheet)) refuse("load", "a sphere", "is implemented on discs only");
    fits(sphere.radius_A);
  }
  void operator()(const PressureLoad&) const {
    check_closed(problem, "load");
    if (problem.pressure_eV_per_A3 != 0)
      refuse("pressure_eV_per_A3", problem.pressure_eV_per_A3, "must be 0 where the load is a pressure itself");
  }
  void operator()(const EdgeMotion& motion) const {
    const auto supports = std::visit(SupportsOf{}, problem.sheet);
    const auto at =
        std::find_if(supports.begin(), supports.end(), [&](const auto& s) { return s.first == motion.edge; });
    if (at == supports.end()) refuse("load.edge", int(motion.edge), "the meshed part of the sheet has no such edge");
    if (at->second != Support::clamped) refuse("load.edge", int(motion.edge), "the edge that moves must be clamped");
    if (!motion.translation_A.allFinite() || !motion.pivot_A.allFinite() || !std::isfinite(motion.rotation_rad))
      refuse("load.translation_A", motion.translation_A.transpose(), "the motion must be finite");
    if (motion.translation_A.norm() + std::abs(motion.rotation_rad) == 0)
      refuse("load.translation_A", 0, "the edge does not move: give a translation or a rotation");
    check_corners(problem, motion);
    if (problem.control != Control::conjugate_depth)
      refuse("control", "force", "a motion is prescribed: control must be conjugate_depth");
    if (problem.pressure_eV_per_A3 != 0)
      refuse("pressure_eV_per_A3", problem.pressure_eV_per_A3, "must be 0 where an edge moves");
  }

 private:
  void has_centre() const {
    check_held(problem);
    if (std::holds_alternative<AnnulusSheet>(problem.sheet))
      refuse("load", "on the centre", "an annulus has no centre: move its hub instead");
  }
  void fits(double radius) const {
    if (!positive(radius) || radius > widest_load * inner_radius_A(problem.sheet))
      refuse("load.radius_A", radius, "must be positive and at most 0.98 of the sheet's radius or half its width");
  }
};

void check_prestress(const Problem& problem) {
  const Eigen::Matrix2d& prestress = problem.prestress_eV_per_A2;
  for (double component : prestress.reshaped())
    if (!std::isfinite(component)) refuse("prestress_eV_per_A2", component, "every component must be finite");
  if (prestress(0, 1) != prestress(1, 0))
    refuse("prestress_eV_per_A2(0,1)", prestress(0, 1), "must equal component (1,0): the tensor is symmetric");
  const auto* rectangle = std::get_if<RectangleSheet>(&problem.sheet);
  if (rectangle && rectangle->extent == Extent::quarter && prestress(0, 1) != 0)
    refuse("prestress_eV_per_A2(0,1)", prestress(0, 1), "breaks the symmetry of a quarter: mesh the full sheet");
}

bool is_quarter(const Sheet& sheet) {
  const auto extent_is = [](const auto& shape) {
    if constexpr (requires { shape.extent; })
      return shape.extent == Extent::quarter;
    else
      return false;
  };
  return std::visit(extent_is, sheet);
}

/// The symmetry planes of a quarter must be the lattice's, too: zigzag and armchair follow each other every 30°.
void check_directions(const Problem& problem) {
  const auto* lattice = std::get_if<CauchyBornSixfold>(&problem.law);
  if (!lattice || !is_quarter(problem.sheet)) return;
  const double mirrors = lattice->zigzag_rad / (std::numbers::pi / 6);
  if (std::abs(mirrors - std::round(mirrors)) > 1e-9)
    refuse("law.zigzag_rad", lattice->zigzag_rad,
           "must be a multiple of 30 degrees on a quarter, or its planes are no mirrors of the lattice: mesh the full "
           "sheet");
  if (problem.prestress_eV_per_A2(0, 1) != 0)
    refuse("prestress_eV_per_A2(0,1)", problem.prestress_eV_per_A2(0, 1),
           "breaks the symmetry of a quarter: mesh the full sheet");
}

bool compressive(const Eigen::Matrix2d& prestress) {
  return Principal(prestress(0, 0), prestress(1, 1), prestress(0, 1)).smaller < 0;
}

void check_levels(const Problem& problem) {
  if (problem.levels.empty())
    refuse("levels", "[]", "at least one is needed: without a load there is nothing to solve");
  const bool bulged = problem.pressure_eV_per_A3 != 0;  // then depths of either sign make sense
  const bool compressed = compressive(problem.prestress_eV_per_A2);
  if (compressed && !bulged && *std::min_element(problem.levels.begin(), problem.levels.end()) == 0)
    refuse("prestress_eV_per_A2", problem.prestress_eV_per_A2.reshaped().transpose(),
           "is compressive, and nothing loads the sheet at level 0: it hangs slack, or buckles if it is not "
           "relaxed");
  for (double level : problem.levels)
    if (!std::isfinite(level) || (!bulged && !(level > 0)))
      refuse("levels", level, bulged ? "every level must be finite" : "every level must be positive and finite");
}

}  // namespace

void check(const Problem& problem) {
  check(problem.sheet);
  std::visit([](const auto& law) { law.check(); }, problem.law);
  if (problem.bending) problem.bending->check();
  if (problem.bending && problem.relaxed)
    refuse("relaxed", "true", "must be false for a sheet that bends: bending is what limits its compression");
  check_prestress(problem);
  check_directions(problem);
  if (!std::isfinite(problem.pressure_eV_per_A3))
    refuse("pressure_eV_per_A3", problem.pressure_eV_per_A3, "must be finite");
  if (problem.pressure_eV_per_A3 != 0) check_closed(problem, "pressure_eV_per_A3");
  std::visit(CheckLoad{problem}, problem.load);
  if (!(problem.record_radius_A >= 0 && problem.record_radius_A < inner_radius_A(problem.sheet)))
    refuse("record_radius_A", problem.record_radius_A, "must be at least 0 and below the sheet's radius");
  check_levels(problem);
  if (!(problem.solver.relative_residual > 0))
    refuse("solver.relative_residual", problem.solver.relative_residual, "must be positive");
}

}  // namespace membrane
