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

std::string compare_curves(const Run& atoms, const Run& membrane, Agreement& agreement) {
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
  result.agreement_skipped = compare_curves(*atoms, *membrane, agreement);
  if (!result.agreement_skipped.empty()) return;
  agreement.passed = agreement.max_relative_difference <= agreement.tolerance;
  result.agreement = std::move(agreement);
}

}  // namespace compare
