#include "compare/results/pulled_rim.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace validate {

bool has_pulled_rim(const Run& run) { return std::isfinite(run.rim_tension_eV_per_A2); }

bool has_pulled_rim(const Result& result) {
  return std::ranges::any_of(result.runs, [](const Run& run) { return has_pulled_rim(run); });
}

double cone_of_a_point(double tension, double depth) { return 2 * std::numbers::pi * tension * depth; }

double cone_factor(double tip_over_radius) { return 1 / (1 - 2 * tip_over_radius / 3); }

double taut_factor(double tip_over_radius) { return 1 / (std::log(1 / tip_over_radius) + 0.5); }

std::string pulled_curve_in_words(const Run& run) {
  const bool borne = run.compression == Compression::borne;
  const char* name = run.model == Model::atomistic ? "atoms"
                     : run.model == Model::sheet   ? "sheet with bending"
                     : borne                       ? "membrane that bears compression"
                                                   : "tension field";
  if (!run.constants) return name;
  if (run.constants == Constants::calibrated) return fmt::format("{}, the potential's own law", name);
  return fmt::format("{}, {} constants", name, *run.constants);
}

}  // namespace validate
