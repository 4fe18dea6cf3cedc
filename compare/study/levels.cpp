#include "compare/study/levels.hpp"

#include <algorithm>

#include "compare/fitting/curve.hpp"
#include "compare/pairing/guides.hpp"
#include "compare/study/continua.hpp"
#include "compare/verdict/agreement.hpp"

namespace validate {
namespace {

using Levels = std::vector<double>;

Levels levels_of(const Case& c, LoadKind load) {
  if (load == LoadKind::pressure) return c.pressures_eV_per_A3;
  return c.forces_eV_per_A.empty() ? depth_levels(c) : c.forces_eV_per_A;
}

/// Without more levels the order stays: dead loads may be given in any.
Levels merged(Levels levels, const Levels& more) {
  if (more.empty()) return levels;
  levels.insert(levels.end(), more.begin(), more.end());
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end(), [](double a, double b) { return b - a < 1e-9 * b; }),
               levels.end());
  return levels;
}

/// step, 2 step, … and the deepest.
Levels grid_levels(double step, double deepest) {
  Levels levels;
  for (int k = 1; k * step < deepest * (1 - 1e-9); ++k) levels.push_back(k * step);
  levels.push_back(deepest);
  return levels;
}

/// Controlled levels with one more before the first and one a little beyond the last: a continuum then covers the
/// atoms' depths, although a level's depth of record is not the same in both.
Levels enclosing(const Levels& levels) {
  constexpr double before = 0.5, beyond = 1.02;
  if (levels.empty()) return levels;
  Levels more = {before * levels.front()};
  more.insert(more.end(), levels.begin(), levels.end());
  more.push_back(beyond * levels.back());
  return more;
}

/// The same with one more between each two: curves that are cheap are known better.
Levels with_halves(const Levels& levels) {
  Levels finer;
  for (const double level : levels) {
    if (!finer.empty()) finer.push_back((finer.back() + level) / 2);
    finer.push_back(level);
  }
  return finer;
}

/// For what makes the atoms' ratio of controlled depth and depth of record another one than a membrane's: bending, by
/// 0.2 % at 110 Å and 1.4 % at 30 Å.
double window_margin(double radius_A) { return 0.005 + 0.6 / radius_A; }

/// Controlled depths at which a curve's depth of record is just below lo and just above hi, as far as it reaches.
Levels window_ends(const Run& scout, double lo_A, double hi_A, double radius_A) {
  const double margin = window_margin(radius_A);
  Levels levels;
  if (scout.depth_A.size() < 2) return levels;
  const Curve controlled(scout.depth_A, scout.conjugate_depth_A);
  for (const double depth : {lo_A * (1 - margin), hi_A * (1 + margin)})
    if (const auto level = controlled.at(depth)) levels.push_back(*level);
  return levels;
}

Run scouted(ContinuumExperiment scout, const Levels& levels) {
  set_levels(scout, levels);
  solve(scout, false, false);
  return std::move(scout.run);
}

Levels membrane_window(const Case& c, const ContinuumExperiment& membrane) {
  const double a = membrane.run.a_A, shallow = 0.5 * c.window.front() * a;
  const Run scout = scouted(membrane, merged(levels_of(c, membrane.run.load), {shallow}));
  return window_ends(scout, c.window.front() * a, c.window.back() * a, c.radius_A);
}

Levels sheet_window(const Case& c, const ContinuumExperiment& sheet) {
  const double step = depth_step_A(c), a = sheet.run.a_A;
  const double deepest = c.depth_max_A.value_or(c.window.back() * a), shallow = 0.5 * c.window.front() * a;
  // Finer than the atoms' steps: near its end a sheet tears within a step.
  constexpr double parts = 4, margin_A = 0.015;  // the latter of the predicted bond, on the smallest sheets
  const Run scout = scouted(sheet, merged(grid_levels(step / parts, deepest), {shallow}));
  if (scout.depth_A.size() < 2) return {};
  const double torn = scout.depth_A.back() / (1 + 2 * window_margin(c.radius_A));
  const double end =
      std::min({c.window.back() * a, torn, depth_at_bond(scout, c.window_bond_A + margin_A).value_or(torn)});
  Levels levels = window_ends(scout, c.window.front() * a, end, c.radius_A);
  if (c.depth_max_A) return levels;
  const double last = levels.empty() ? 0 : levels.back();
  for (const double level : grid_levels(step, last))
    if (level > largest_depth_A(c)) levels.push_back(level);
  return levels;
}

/// More controlled depths for the judged load, by the continuum that it is judged against: just below the window's
/// lower end, just above its upper one, and those in between that the case's own list leaves out.
Levels window_levels(const Case& c, const PairedLoad& pair) {
  if (pair.load != c.judged_load || c.models != Models::both || !pair.atoms || has_pulled_rim(c)) return {};
  if (!c.forces_eV_per_A.empty() || pair.load == LoadKind::pressure) return {};
  if (c.against == Against::sheet) {
    const ContinuumExperiment* sheet = pair.find(Purpose::calibrated_sheet);
    return sheet ? sheet_window(c, *sheet) : Levels();
  }
  return membrane_window(c, *pair.find(Purpose::like_for_like));
}

/// Levels of a continuum beside atoms that have `levels`.
Levels beside(const Case& c, Purpose purpose, LoadKind load, const Levels& levels) {
  const bool depths = load != LoadKind::pressure && c.forces_eV_per_A.empty();
  switch (purpose) {
    case Purpose::given:
    case Purpose::compression_borne:
    case Purpose::paper:
      return levels_of(c, load);
    case Purpose::like_for_like:
      return depths ? enclosing(levels) : levels;
    case Purpose::calibrated_membrane:
    case Purpose::calibrated_sheet:
    case Purpose::nominal_radii:
    case Purpose::paired_radii:
    case Purpose::bending:
      return depths ? with_halves(enclosing(levels)) : levels;
  }
  return levels;
}

}  // namespace

void set_levels(ContinuumExperiment& e, const Levels& levels) { e.problem.levels = levels; }

namespace {

/// A perfect lattice has no reason to leave its round shape: every level starts with a little of the waves that the
/// sheet with bending has at the last one.
void start_wrinkled(PairedLoad& pair) {
  constexpr double start_A = 0.1;
  const ContinuumExperiment* sheet = pair.find(Purpose::calibrated_sheet);
  if (!sheet) return;
  const Run wrinkled = scouted(*sheet, pair.atoms->problem.levels);
  int count = 0;
  for (const int one : wrinkled.wrinkle_count)
    if (one > 0) count = one;
  if (count == 0) return;
  pair.atoms->problem.ripple_A = start_A;
  pair.atoms->problem.ripple_waves = count;
}

}  // namespace

void set_levels(const Case& c, PairedLoad& pair) {
  const Levels levels = merged(levels_of(c, pair.load), window_levels(c, pair));
  for (ContinuumExperiment& e : pair.continua) set_levels(e, beside(c, e.purpose, pair.load, levels));
  if (!pair.atoms) return;
  pair.atoms->problem.levels = levels;
  if (has_pulled_rim(c)) start_wrinkled(pair);
  if (!pair.guide) return;
  set_levels(*pair.guide, levels);
  pair.atoms->problem.guides = guides_from(pair.guide->problem);
}

}  // namespace validate
