#include "compare/agreement.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "compare/curve.hpp"

namespace compare {

namespace {

const Run* find_run(const Result& result, Model model, Constants constants, const std::string& load) {
  const auto match = [&](const Run& run) {
    return run.model == model && run.constants == constants && run.load == load;
  };
  const auto found = std::ranges::find_if(result.runs, match);
  return found == result.runs.end() ? nullptr : &*found;
}

struct Judged {
  std::vector<std::size_t> points;
  std::string missing;  // why the window is not covered
};

// A depth that was asked for as lo·a or hi·a comes back with the solver's rounding.
constexpr double depth_rounding = 1e-6;

Judged judged_points(const Run& atoms, double lo, double hi) {
  std::vector<std::size_t> order = usable_points(atoms);
  const auto relative = [&](std::size_t i) { return atoms.depth_A[i] / atoms.a_A; };
  std::ranges::sort(order, {}, relative);
  const auto above_lo =
      std::ranges::find_if(order, [&](std::size_t i) { return relative(i) > lo * (1 + depth_rounding); });
  const auto at_hi =
      std::ranges::find_if(order, [&](std::size_t i) { return relative(i) >= hi * (1 - depth_rounding); });

  if (order.empty()) return {{}, "the atoms' curve has no usable point"};
  if (above_lo == order.begin()) {
    return {{},
            fmt::format("the atoms' curve begins at depth/a = {:.3f}, the window at {:.3f}",
                        relative(order.front()), lo)};
  }
  if (at_hi == order.end()) {
    return {{},
            fmt::format("the atoms' curve ends at depth/a = {:.3f} ({}), the window at {:.3f}",
                        relative(order.back()), to_string(atoms.ended), hi)};
  }
  return {{above_lo - 1, at_hi + 1}, {}};
}

// Fills the judged points; returns why that was not possible, or nothing.
std::string compare_points(const Run& atoms, const std::vector<std::size_t>& points, const Curve& continuum,
                           Agreement& agreement) {
  for (const std::size_t i : points) {
    const double depth = atoms.depth_A[i];
    const std::optional<double> force = continuum.at(depth);
    if (!force) {
      return fmt::format(
          "the membrane's curve covers depths from {:.2f} to {:.2f} Å, not the atoms' {:.2f} Å",
          continuum.lowest_A(), continuum.highest_A(), depth);
    }
    const double ratio = atoms.force_eV_per_A[i] / *force;
    agreement.depth_A.push_back(depth);
    agreement.ratio.push_back(ratio);
    agreement.max_relative_difference = std::max(agreement.max_relative_difference, std::abs(ratio - 1));
  }
  return {};
}

std::string judge_curves(const Run& atoms, const Run& membrane, Agreement& agreement) {
  const Judged judged = judged_points(atoms, agreement.window[0], agreement.window[1]);
  if (!judged.missing.empty()) return judged.missing;
  try {
    return compare_points(atoms, judged.points, Curve(membrane), agreement);
  } catch (const std::invalid_argument& nothing_to_interpolate) {
    return fmt::format("the membrane's usable points make no curve: {}", nothing_to_interpolate.what());
  }
}

}  // namespace

void judge(Result& result) {
  const Case& asked = result.resolved;
  result.agreement.reset();
  const Run* atoms = find_run(result, Model::atomistic, Constants::none, asked.judged_load);
  const Run* membrane = find_run(result, Model::membrane, Constants::card, asked.judged_load);
  if (!atoms || !membrane) {
    result.agreement_skipped =
        fmt::format("there is no {} run of the {} load", atoms ? "membrane (card constants)" : "atomistic",
                    asked.judged_load);
    return;
  }
  Agreement agreement;
  agreement.load = asked.judged_load;
  agreement.against = to_string(membrane->model);
  agreement.window = {asked.window.at(0), asked.window.at(1)};
  agreement.tolerance = asked.tolerance;
  result.agreement_skipped = judge_curves(*atoms, *membrane, agreement);
  if (!result.agreement_skipped.empty()) return;
  agreement.passed = agreement.max_relative_difference <= agreement.tolerance;
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

Regime regime_of(double ratio, bool artefact, double tolerance) {
  if (artefact) return Regime::artefact;
  if (ratio > 1 + tolerance) return Regime::bending;
  return ratio < 1 - tolerance ? Regime::softening : Regime::membrane;
}

Curve curve_of(const Run& run, const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<double> at, value;
  for (const std::size_t i : usable_points(run)) {
    at.push_back(x[i]);
    value.push_back(y[i]);
  }
  return Curve(at, value);
}

Comparison comparison_of(const Run& atoms, const Run& membrane, double tolerance) {
  const Curve force(membrane), energy = curve_of(membrane, membrane.depth_A, membrane.energy_eV),
                               depth = curve_of(membrane, membrane.force_eV_per_A, membrane.depth_A);
  Comparison c{.load = atoms.load};
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < atoms.depth_A.size(); ++i)
    if (atoms.converged[i] && atoms.depth_A[i] > 0) order.push_back(i);
  std::ranges::sort(order, {}, [&](std::size_t i) { return atoms.depth_A[i]; });
  for (const std::size_t i : order) {
    const auto F = force.at(atoms.depth_A[i]), W = energy.at(atoms.depth_A[i]);
    if (!F || !W) continue;
    c.depth_A.push_back(atoms.depth_A[i]);
    c.depth_relative.push_back(atoms.depth_A[i] / atoms.a_A);
    c.force_ratio.push_back(atoms.force_eV_per_A[i] / *F);
    c.energy_ratio.push_back(atoms.energy_eV[i] / *W);
    const auto d = depth.at(atoms.force_eV_per_A[i]);
    c.depth_ratio.push_back(d ? atoms.depth_A[i] / *d : not_known);
    c.regime.push_back(regime_of(c.force_ratio.back(), atoms.artefact[i], tolerance));
    if (atoms.artefact[i] && !std::isfinite(c.artefact_from_A)) c.artefact_from_A = atoms.depth_A[i];
  }
  c.bending_to_A = crossing(c, 1 + tolerance);
  c.softening_from_A = crossing(c, 1 - tolerance);
  return c;
}

}  // namespace

void compare_curves(Result& result) {
  result.comparisons.clear();
  for (const Run& atoms : result.runs) {
    if (atoms.model != Model::atomistic) continue;
    const Run* membrane = find_run(result, Model::membrane, Constants::card, atoms.load);
    if (!membrane) continue;
    try {
      result.comparisons.push_back(comparison_of(atoms, *membrane, result.resolved.tolerance));
    } catch (const std::invalid_argument&) {  // too few points for a curve
    }
  }
}

}  // namespace compare
