// What was done to an instrument's curve before it is fitted.
#pragma once

#include <optional>
#include <vector>

#include "compare/base/describe.hpp"
#include "compare/base/words.hpp"

namespace validate {

/// What is taken off the forces: nothing, their level before the contact, or a straight line through it.
enum class Baseline { none, level, tilt };
constexpr auto words(Baseline) {
  return std::array{Word{Baseline::none, "none"}, Word{Baseline::level, "level"}, Word{Baseline::tilt, "tilt"}};
}

/// Attraction on the way in: the points of it are left out.
struct SnapIn {
  double force_eV_per_A = 0;  ///< largest, > 0
  int points = 0;
};

void describe(SameStruct<SnapIn> auto& snap, auto&& visit) {
  visit(Field{"force", unit::force, "largest attraction before the contact"}, snap.force_eV_per_A);
  visit(Field{"points", unit::none, "left out of the fit"}, snap.points);
}

/// Adhesion on the way back.
struct PullOff {
  double force_eV_per_A = 0;  ///< > 0
  double work_eV = 0;
};

void describe(SameStruct<PullOff> auto& pull, auto&& visit) {
  visit(Field{"force", unit::force, "largest adhesion on the way back"}, pull.force_eV_per_A);
  visit(Field{"work", unit::energy, "between adhesion and baseline, over the tip's way"}, pull.work_eV);
}

struct CurvePreparation {
  Baseline baseline = Baseline::none;
  double level_eV_per_A = 0;   ///< taken off at the contact
  double tilt_eV_per_A2 = 0;   ///< and in proportion to the height from there
  double noise_eV_per_A = 0;   ///< standard deviation about the baseline
  int baseline_points = 0;     ///< that it goes through
  double contact_A = 0;        ///< first estimate among the raw heights, the zero of the depths
  bool height_turned = false;  ///< heights that fell towards the sample
  bool force_turned = false;   ///< a force that fell where the tip presses
  std::optional<SnapIn> snap_in;
  std::optional<PullOff> pull_off;                       ///< absent: no way back, or none seen
  std::vector<double> raw_height_A, raw_force_eV_per_A;  ///< of the segment, signs turned
};

void describe(SameStruct<CurvePreparation> auto& p, auto&& visit) {
  visit(Field{"baseline", unit::none, "what was taken off the forces"}, p.baseline);
  visit(Field{"level", unit::force, "of the baseline at the contact"}, p.level_eV_per_A);
  visit(Field{"tilt", unit::membrane_force, "of the baseline over the height"}, p.tilt_eV_per_A2);
  visit(Field{"noise", unit::force, "standard deviation about the baseline"}, p.noise_eV_per_A);
  visit(Field{"baseline_points", unit::none, "that the baseline goes through"}, p.baseline_points);
  visit(Field{"contact", unit::length, "first estimate among the raw heights: the zero of the depths"}, p.contact_A);
  visit(Field{"height_turned", unit::none, "heights that fell towards the sample"}, p.height_turned);
  visit(Field{"force_turned", unit::none, "a force that fell where the tip presses"}, p.force_turned);
  visit(Field{"snap_in", unit::none, "attraction before the contact, cut off"}.where_known(), p.snap_in);
  visit(Field{"pull_off", unit::none, "adhesion on the way back"}.where_known(), p.pull_off);
  visit(Column{"raw_height", unit::length, "of the segment, growing towards the sample"}.where_known(), p.raw_height_A);
  visit(Column{"raw_force", unit::force, "of the segment, before the baseline is taken off"}.where_known(),
        p.raw_force_eV_per_A);
}

}  // namespace validate
