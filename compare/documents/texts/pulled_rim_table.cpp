#include "compare/documents/texts/pulled_rim_table.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "compare/documents/texts/numbers.hpp"
#include "compare/results/pulled_rim.hpp"

namespace validate {
namespace {

std::string heading(const Run& run) {
  const double tension = run.rim_tension_eV_per_A2;
  return fmt::format(
      "disc of {:g} Å whose rim slides under {:.4g} N/m ({:.3g} of E·h), {} load of {:.4g} Å, nu = {:g}\n\n", run.a_A,
      in_N_per_m(tension), tension / run.Eh_eV_per_A2, run.load, run.tip_A, run.nu);
}

/// What the atoms' free edge adds to the tension.
std::string edge(const Result& result) {
  if (!result.sheet || !std::isfinite(result.sheet->flat_tension_eV_per_A2)) return {};
  return fmt::format(
      "the rim's dead force is {:.4g} N/m; the atoms' free edge (stress {:.3f} eV/Å, stiffness {:.3g} eV/Å) adds the "
      "rest\n\n",
      in_N_per_m(result.resolved.rim_tension_eV_per_A2.value_or(0)), result.sheet->edge_stress_eV_per_A,
      result.sheet->edge_stiffness_eV_per_A);
}

std::string percent(const std::vector<double>& shares, std::size_t i) {
  return i < shares.size() ? number(100 * shares[i], "{:.1f}") : "–";
}

/// A share of the area where it is known, a dash for what the model has not.
std::string area(const Run& run, std::vector<double> ContinuumPart::*shares, std::size_t i) {
  const auto* part = std::get_if<ContinuumPart>(&run.part);
  return part ? percent(part->*shares, i) : "–";
}

std::string least_force(const Run& run, std::size_t i) {
  const auto* part = std::get_if<ContinuumPart>(&run.part);
  return part ? number(part->least_membrane_force_eV_per_A2[i], "{:.5f}") : "–";
}

/// Number, length and height of the waves around the axis; empty cells where none are looked for.
std::array<std::string, 3> waves(const Run& run, std::size_t i) {
  if (i >= run.wrinkle_count.size()) return {};
  return {fmt::format("{}", run.wrinkle_count[i]), number(run.wrinkle_wavelength_A[i], "{:.1f}"),
          number(run.wrinkle_amplitude_A[i], "{:.3f}")};
}

std::string rows(const Run& run, int width) {
  TextTable table({{.heading = "depth", .unit = "Å"},
                   {.heading = "depth/a"},
                   {.heading = "force", .unit = "eV/Å"},
                   {.heading = "F/2πTδ"},
                   {.heading = "wrinkled", .unit = "%", .rank = 1},
                   {.heading = "compressed", .unit = "%", .rank = 2},
                   {.heading = "least force", .unit = "eV/Å²", .rank = 4},
                   {.heading = "rim", .unit = "Å", .rank = 3},
                   {.heading = "waves"},
                   {.heading = "length", .unit = "Å"},
                   {.heading = "height", .unit = "Å"},
                   {.heading = "", .align = Align::left}});
  for (std::size_t i = 0; i < run.depth_A.size(); ++i) {
    const auto [count, length, height] = waves(run, i);
    table.add({number(run.depth_A[i], "{:.3f}"), number(run.depth_A[i] / run.a_A, "{:.4f}"),
               number(run.force_eV_per_A[i], "{:.5g}"),
               number(run.force_eV_per_A[i] / cone_of_a_point(run.rim_tension_eV_per_A2, run.depth_A[i]), "{:.4f}"),
               area(run, &ContinuumPart::wrinkled_area_fraction, i),
               area(run, &ContinuumPart::compressed_area_fraction, i), least_force(run, i),
               number(run.rim_displacement_A[i], "{:.3f}"), count, length, height,
               run.converged[i] ? "" : "not converged"});
  }
  return pulled_curve_in_words(run) + "\n" + table.text(width) + "\n";
}

std::string closed_forms(const Run& run) {
  const double share = run.tip_A / run.a_A;
  if (!(share > 0)) return {};
  return fmt::format(
      "closed forms of F/2πTδ at small slopes: taut 1/(ln(a/c) + 1/2) = {:.4f}, wrinkled all over 1/(1 - 2c/3a) = "
      "{:.4f}\n",
      taut_factor(share), cone_factor(share));
}

}  // namespace

std::string pulled_rim_table(const Result& result, int width) {
  std::string text;
  std::optional<LoadKind> load;
  for (const Run& run : result.runs) {
    if (!has_pulled_rim(run)) continue;
    if (load != run.load)
      text += heading(run) + edge(result) + (run.load == LoadKind::sphere ? "" : closed_forms(run) + "\n");
    load = run.load;
    text += rows(run, width);
  }
  return text;
}

}  // namespace validate
