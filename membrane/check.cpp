// What makes a problem unsolvable before anything is computed.
#include "membrane/check.hpp"

#include <cmath>

#include "membrane/grading.hpp"
#include "membrane/refusal.hpp"

namespace membrane {
namespace {

constexpr int most_rings = 2000;
constexpr double widest_load = 0.98;  // of the sheet: there must be room for a ring of triangles outside

bool positive(double x) { return x > 0 && std::isfinite(x); }

struct CheckLoad {
  double sheet_radius;
  void operator()(const PointLoad&) const {}
  void operator()(const DiscLoad& disc) const {
    if (!positive(disc.radius_A) || disc.radius_A > widest_load * sheet_radius)
      refuse("load.radius_A", disc.radius_A, "must be positive and at most 0.98 of sheet.radius_A");
  }
};

void check_prestress(const Eigen::Matrix2d& prestress) {
  for (double component : prestress.reshaped())
    if (!std::isfinite(component)) refuse("prestress_eV_per_A2", component, "every component must be finite");
  if (prestress(0, 1) != prestress(1, 0))
    refuse("prestress_eV_per_A2(0,1)", prestress(0, 1),
           "must equal component (1,0): the tensor is symmetric");
}

}  // namespace

void check(const Problem& problem) {
  const DiscSheet& sheet = problem.sheet;
  if (!positive(sheet.radius_A)) refuse("sheet.radius_A", sheet.radius_A, "must be positive and finite");
  if (sheet.rings < fewest_rings || sheet.rings > most_rings)
    refuse("sheet.rings", sheet.rings, "must lie between 8 and 2000");
  std::visit([](const auto& law) { law.check(); }, problem.law);
  check_prestress(problem.prestress_eV_per_A2);
  std::visit(CheckLoad{sheet.radius_A}, problem.load);
  if (!(problem.record_radius_A >= 0 && problem.record_radius_A < sheet.radius_A))
    refuse("record_radius_A", problem.record_radius_A, "must be at least 0 and below sheet.radius_A");
  if (problem.levels.empty()) refuse("levels", "[]", "at least one depth or force is needed");
  for (double level : problem.levels)
    if (!positive(level)) refuse("levels", level, "every level must be positive and finite");
}

}  // namespace membrane
