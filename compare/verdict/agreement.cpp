#include "compare/verdict/agreement.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "compare/fitting/curve.hpp"
#include "compare/verdict/regimes.hpp"

namespace validate {

namespace {

const Run* find_run(const Result& result, Model model, std::optional<Constants> constants, LoadKind load) {
  const auto match = [&](const Run& run) {
    return run.model == model && run.constants == constants && run.load == load;
  };
  const auto found = std::ranges::find_if(result.runs, match);
  return found == result.runs.end() ? nullptr : &*found;
}

struct Judged {
  std::vector<std::size_t> points;
  double end_A = 0;     // of the range judged
  std::string missing;  // why the window is not covered
};

// A depth that was asked for as lo·a or hi·a comes back with the solver's rounding.
constexpr double depth_rounding = 1e-6;

std::vector<std::size_t> by_depth(const Run& run, std::vector<std::size_t> points) {
  std::ranges::sort(points, {}, [&](std::size_t i) { return run.depth_A[i]; });
  return points;
}

std::vector<std::size_t> converged_points(const Run& run) {
  std::vector<std::size_t> points;
  for (std::size_t i = 0; i < run.depth_A.size(); ++i)
    if (run.converged[i] && run.depth_A[i] > 0) points.push_back(i);
  return by_depth(run, points);
}

// The window [lo, hi] in Å, cut off at the depth where the bond is too long or where the path was meant to end.
Judged judged_points(const Run& atoms, double lo, double hi, double bond_A) {
  const std::vector<std::size_t> order = by_depth(atoms, usable_points(atoms));
  if (order.empty()) return {{}, 0, "the atoms' curve has no usable point"};
  const double too_long = depth_at_bond(atoms, bond_A).value_or(std::numeric_limits<double>::infinity());
  double end = std::min(hi, too_long);
  if (atoms.ended == Ended::depth_max) end = std::min(end, atoms.depth_A[order.back()]);

  const auto depth = [&](std::size_t i) { return atoms.depth_A[i]; };
  const auto above_lo =
      std::ranges::find_if(order, [&](std::size_t i) { return depth(i) > lo * (1 + depth_rounding); });
  if (above_lo == order.begin())
    return {{},
            0,
            fmt::format("the atoms' curve begins at depth/a = {:.3f}, the window at {:.3f}",
                        depth(order.front()) / atoms.a_A, lo / atoms.a_A)};
  auto last = std::ranges::find_if(order, [&](std::size_t i) { return depth(i) >= end * (1 - depth_rounding); });
  if (last == order.end() && end < too_long)
    return {{},
            0,
            fmt::format("the atoms' curve ends at depth/a = {:.3f} ({}), the window at {:.3f}",
                        depth(order.back()) / atoms.a_A, to_string(atoms.ended), end / atoms.a_A)};
  if (last != order.end() && depth(*last) < too_long) ++last;
  if (above_lo >= last)
    return {{},
            0,
            fmt::format("the atoms' curve has no point between depth/a = {:.3f} and {:.3f}", lo / atoms.a_A,
                        end / atoms.a_A)};
  return {{above_lo - 1, last}, end, {}};
}

// Fills the judged points; returns why that was not possible, or nothing.
std::string compare_points(const Run& atoms, const std::vector<std::size_t>& points, const Curve& continuum,
                           Agreement& agreement) {
  for (const std::size_t i : points) {
    const double depth = atoms.depth_A[i];
    const std::optional<double> force = continuum.at(depth);
    if (!force) {
      return fmt::format("the {}'s curve covers depths from {:.2f} to {:.2f} Å, not the atoms' {:.2f} Å",
                         to_string(agreement.against), continuum.lowest_A(), continuum.highest_A(), depth);
    }
    const double ratio = load_values(atoms)[i] / *force;
    JudgedRatio judged;
    judged.depth_A = depth;
    judged.ratio = ratio;
    agreement.ratios.push_back(judged);
  }
  return {};
}

std::string judge_curves(const Run& atoms, const Run& continuum, double bond_A, Agreement& agreement) {
  const Judged judged = judged_points(atoms, agreement.window[0] * atoms.a_A, agreement.window[1] * atoms.a_A, bond_A);
  if (!judged.missing.empty()) return judged.missing;
  agreement.window[1] = judged.end_A / atoms.a_A;
  try {
    return compare_points(atoms, judged.points, Curve(continuum), agreement);
  } catch (const std::invalid_argument& nothing_to_interpolate) {
    return fmt::format("the {}'s usable points make no curve: {}", to_string(agreement.against),
                       nothing_to_interpolate.what());
  }
}

/// The continuum that a case asks for, as runs have it.
struct Continuum {
  Model model;
  Constants constants;
  const char* words;
};

Continuum continuum_of(const Case& asked) {
  if (asked.against == Against::membrane) return {Model::membrane, Constants::card, "membrane (card constants)"};
  return {Model::sheet, Constants::calibrated, "sheet (calibrated law)"};
}

}  // namespace

std::optional<double> depth_at_bond(const Run& run, double bond_A) {
  if (run.longest_bond_A.size() != run.depth_A.size()) return std::nullopt;
  double depth_before = 0, bond_before = 0;
  for (const std::size_t i : converged_points(run)) {
    const double bond = run.longest_bond_A[i];
    if (bond >= bond_A) {
      if (!(bond_before > 0)) return run.depth_A[i];
      return std::lerp(depth_before, run.depth_A[i], (bond_A - bond_before) / (bond - bond_before));
    }
    depth_before = run.depth_A[i];
    bond_before = bond;
  }
  return std::nullopt;
}

void settle(Agreement& agreement) {
  bool all_within = true, one_beyond = false;
  agreement.max_relative_difference = agreement.expanded_uncertainty = 0;
  for (const JudgedRatio& judged : agreement.ratios) {
    const double difference = std::abs(judged.ratio - 1), uncertainty = judged.expanded();
    all_within = all_within && difference + uncertainty <= agreement.tolerance;
    one_beyond = one_beyond || difference - uncertainty > agreement.tolerance;
    agreement.max_relative_difference = std::max(agreement.max_relative_difference, difference);
    if (uncertainty > agreement.expanded_uncertainty) {
      agreement.expanded_uncertainty = uncertainty;
      double largest = 0;
      describe(judged.shares, [&](const Field& source, double u) {
        if (u <= largest) return;
        largest = u;
        agreement.dominant = source.name;
      });
    }
  }
  agreement.outcome = all_within ? Outcome::agree : one_beyond ? Outcome::disagree : Outcome::undecided;
}

void judge(Result& result) {
  const Case& asked = result.resolved;
  result.agreement.reset();
  const Continuum against = continuum_of(asked);
  const Run* atoms = find_run(result, Model::atomistic, std::nullopt, asked.judged_load);
  const Run* continuum = find_run(result, against.model, against.constants, asked.judged_load);
  if (!atoms || !continuum) {
    result.agreement_skipped = fmt::format("there is no {} run of the {} load", atoms ? against.words : "atomistic",
                                           to_string(asked.judged_load));
    if (atoms && against.model == Model::sheet && !result.law_missing.empty())
      result.agreement_skipped += ": " + result.law_missing;
    return;
  }
  Agreement agreement;
  agreement.load = asked.judged_load;
  agreement.against = continuum->model;
  agreement.window = {asked.window.at(0), asked.window.at(1)};
  agreement.tolerance = asked.tolerance;
  result.agreement_skipped = judge_curves(*atoms, *continuum, asked.window_bond_A, agreement);
  if (!result.agreement_skipped.empty()) return;
  settle(agreement);
  result.agreement = std::move(agreement);
}

namespace {

/// Depth at which a ratio that falls with depth passes a value, between the points around it.
double crossing(const Comparison& c, double value) {
  for (std::size_t i = 1; i < c.depth_A.size(); ++i) {
    const double before = c.force_ratio[i - 1], here = c.force_ratio[i];
    if (!(before > value && here <= value)) continue;
    return std::lerp(c.depth_A[i - 1], c.depth_A[i], (before - value) / (before - here));
  }
  return not_known;
}

/// A curve's y at any x: its own value where it has this x (curves under the same pressures), interpolated between,
/// nothing beyond and where there is no curve.
class Lookup {
 public:
  Lookup(const Run* run, const std::vector<double>& x, const std::vector<double>& y) {
    if (!run) return;
    for (const std::size_t i : usable_points(*run)) {
      x_.push_back(x[i]);
      y_.push_back(y[i]);
    }
    try {
      curve_.emplace(x_, y_);
    } catch (const std::invalid_argument&) {  // too few points for one
    }
  }

  double at(double x) const {
    constexpr double same = 1e-12;
    for (std::size_t i = 0; i < x_.size(); ++i)
      if (std::abs(x_[i] - x) <= same * std::abs(x)) return y_[i];
    return curve_ ? curve_->at(x).value_or(not_known) : not_known;
  }

 private:
  std::vector<double> x_, y_;
  std::optional<Curve> curve_;
};

Lookup loads_by_depth(const Run* run) {
  return run ? Lookup(run, run->depth_A, load_values(*run)) : Lookup(nullptr, {}, {});
}
Lookup depths_by_load(const Run* run) {
  return run ? Lookup(run, load_values(*run), run->depth_A) : Lookup(nullptr, {}, {});
}

Comparison comparison_of(const Result& result, const Run& atoms, const Run& membrane) {
  const double tolerance = result.resolved.regime_tolerance;
  const Run* sheet = find_run(result, Model::sheet, Constants::calibrated, atoms.load);
  const Run* calibrated = find_run(result, Model::membrane, Constants::calibrated, atoms.load);
  const Lookup force = loads_by_depth(&membrane), depth = depths_by_load(&membrane),
               energy(&membrane, membrane.depth_A, membrane.energy_eV), sheet_force = loads_by_depth(sheet),
               sheet_depth = depths_by_load(sheet), calibrated_force = loads_by_depth(calibrated);
  Comparison c;
  c.load = atoms.load;
  std::vector<bool> artefacts;
  for (const std::size_t i : converged_points(atoms)) {
    const double d = atoms.depth_A[i], F = load_values(atoms)[i];
    const double force_ratio = F / force.at(d), depth_ratio = d / depth.at(F);
    if (!std::isfinite(force_ratio) && !(atoms.load == LoadKind::pressure && std::isfinite(depth_ratio))) continue;
    const bool artefact = atoms.atoms().artefact[i];
    c.depth_A.push_back(d);
    c.depth_relative.push_back(d / atoms.a_A);
    c.force_ratio.push_back(force_ratio);
    c.depth_ratio.push_back(depth_ratio);
    c.energy_ratio.push_back(atoms.energy_eV[i] / energy.at(d));
    c.calibrated_membrane_ratio.push_back(F / calibrated_force.at(d));
    c.sheet_ratio.push_back(F / sheet_force.at(d));
    c.sheet_depth_ratio.push_back(d / sheet_depth.at(F));
    artefacts.push_back(artefact);
    if (artefact && !std::isfinite(c.artefact_from_A)) c.artefact_from_A = d;
  }
  if (sheet) c.predicted_artefact_from_A = depth_at_bond(*sheet, artefact_bond_of(result)).value_or(not_known);
  const auto explanation = std::ranges::find(result.explanations, atoms.load, &Explanation::load);
  c.regime = regimes_of(c, artefacts, explanation == result.explanations.end() ? nullptr : &*explanation, tolerance);
  c.bending_to_A = crossing(c, 1 + tolerance);
  c.softening_from_A = crossing(c, 1 - tolerance);
  return c;
}

}  // namespace

void compare_curves(Result& result) {
  result.comparisons.clear();
  for (const Run& atoms : result.runs) {
    if (!atoms.is_atomistic()) continue;
    const Run* membrane = find_run(result, Model::membrane, Constants::card, atoms.load);
    if (!membrane) continue;
    Comparison comparison = comparison_of(result, atoms, *membrane);
    // A membrane of one point, or none, has no curve to compare with.
    if (!comparison.depth_A.empty() || usable_points(*membrane).size() > 1)
      result.comparisons.push_back(std::move(comparison));
  }
}

}  // namespace validate
