#include "compare/verdict/regimes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace validate {
namespace {

Regime by_ratio(double ratio, double tolerance) {
  if (ratio > 1 + tolerance) return Regime::bending;
  return ratio < 1 - tolerance ? Regime::softening : Regime::membrane;
}

/// The radii are the same in the like-for-like membrane, and no part of it.
Regime by_contributions(const Explanation& e, std::size_t i, double tolerance) {
  const double bending = e.bending[i], law = e.large_strain[i];
  if (std::max(std::abs(bending), std::abs(law)) <= tolerance) return Regime::membrane;
  constexpr double notable = 0.5;  // of the larger
  const bool opposite = bending * law < 0,
             alike = std::min(std::abs(bending), std::abs(law)) >= notable * std::max(std::abs(bending), std::abs(law));
  if (opposite && alike && std::abs(bending + law) <= tolerance) return Regime::cancellation;
  if (std::abs(bending) >= std::abs(law)) return Regime::bending;
  return law < 0 ? Regime::softening : Regime::hardening;
}

std::optional<std::size_t> place_of(double depth_A, const Explanation& e) {
  const auto found = std::ranges::find(e.depth_A, depth_A);
  if (found == e.depth_A.end()) return std::nullopt;
  return static_cast<std::size_t>(found - e.depth_A.begin());
}

}  // namespace

std::vector<Regime> regimes_of(const Comparison& c, const std::vector<bool>& artefact, const Explanation* explanation,
                               double tolerance) {
  std::vector<Regime> regimes;
  for (std::size_t i = 0; i < c.depth_A.size(); ++i) {
    const auto place = explanation ? place_of(c.depth_A[i], *explanation) : std::nullopt;
    regimes.push_back(artefact[i] ? Regime::artefact
                      : place     ? by_contributions(*explanation, *place, tolerance)
                                  : by_ratio(c.force_ratio[i], tolerance));
  }
  return regimes;
}

}  // namespace validate
