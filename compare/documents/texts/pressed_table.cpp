#include "compare/documents/texts/pressed_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/base/units.hpp"
#include "compare/documents/texts/numbers.hpp"

namespace validate {
namespace {

const Run* pressed(const Result& result, Model model) {
  const auto found = std::ranges::find_if(
      result.runs, [&](const Run& run) { return run.load == LoadKind::pressure && run.model == model; });
  return found == result.runs.end() ? nullptr : &*found;
}

std::string heading(const Result& result, const Run& run) {
  const Case& c = result.resolved;
  return fmt::format("{} of {:g} Å, edge {}, E·h = {:.4g} eV/Å² ({:.4g} N/m), nu = {:g}, {} triangles on the {}{}\n\n",
                     c.shape, 2 * c.radius_A, c.edge, run.Eh_eV_per_A2, run.Eh_eV_per_A2 * N_per_m_per_eV_per_A2,
                     run.nu, run.continuum().triangles, c.extent == Extent::quarter ? "quarter" : "full sheet",
                     c.unrelaxed ? ", compression allowed" : "");
}

std::string mark(bool converged) { return converged ? "" : "not converged"; }

std::string membrane_rows(const Run& run, int width) {
  TextTable table({{.heading = "pressure", .unit = "eV/Å³"},
                   {.heading = "centre", .unit = "Å"},
                   {.heading = "volume", .unit = "Å³", .rank = 3},
                   {.heading = "wrinkled", .unit = "%"},
                   {.heading = "slack", .unit = "%", .rank = 2},
                   {.heading = "pull-in", .unit = "Å", .rank = 1},
                   {.heading = "max stress", .unit = "eV/Å³"},
                   {.heading = "min of 2nd", .unit = "eV/Å³", .rank = 5},
                   {.heading = "max of 2nd", .unit = "eV/Å³", .rank = 4},
                   {.heading = "", .align = Align::left}});
  const ContinuumPart& part = run.continuum();
  for (std::size_t i = 0; i < run.depth_A.size(); ++i)
    table.add({fmt::format("{:.4e}", run.pressure_eV_per_A3[i]), number(run.depth_A[i], "{:.3f}"),
               number(run.volume_A3[i], "{:.5g}"), number(100 * part.wrinkled_area_fraction[i], "{:.1f}"),
               number(100 * part.slack_area_fraction[i], "{:.1f}"), number(part.edge_pull_in_A[i], "{:.2f}"),
               number(part.stress_1_max_eV_per_A3[i], "{:.5f}"), number(part.stress_2_min_eV_per_A3[i], "{:.5f}"),
               number(part.stress_2_max_eV_per_A3[i], "{:.5f}"), mark(run.converged[i])});
  return table.text(width);
}

std::string atoms_rows(const Result& result, const Run& atoms, int width) {
  const auto found = std::ranges::find(result.comparisons, LoadKind::pressure, &Comparison::load);
  if (found == result.comparisons.end()) return {};
  const Comparison& c = *found;
  TextTable table({{.heading = "pressure", .unit = "eV/Å³"},
                   {.heading = "atoms' depth", .unit = "Å"},
                   {.heading = "membrane's", .unit = "Å"},
                   {.heading = "ratio"},
                   {.heading = "sheet's", .unit = "Å"},
                   {.heading = "ratio"},
                   {.heading = "longest bond", .unit = "Å", .rank = 1},
                   {.heading = "evaluations", .rank = 2},
                   {.heading = "", .align = Align::left}});
  for (std::size_t i = 0; i < atoms.depth_A.size(); ++i) {
    const auto at = std::ranges::find(c.depth_A, atoms.depth_A[i]) - c.depth_A.begin();
    const auto k = static_cast<std::size_t>(at);
    const bool known = k < c.depth_A.size();
    const double depth = atoms.depth_A[i], ratio = known ? c.depth_ratio[k] : not_known,
                 sheet = known ? c.sheet_depth_ratio[k] : not_known;
    table.add({fmt::format("{:.4e}", atoms.pressure_eV_per_A3[i]), number(depth, "{:.3f}"),
               number(depth / ratio, "{:.3f}"), number(ratio, "{:.4f}"), number(depth / sheet, "{:.3f}"),
               number(sheet, "{:.4f}"), number(atoms.longest_bond_A[i], "{:.4f}"),
               fmt::format("{}", atoms.atoms().force_evaluations[i]), mark(atoms.converged[i])});
  }
  std::string text = "\n" + table.text(width);
  if (pressed(result, Model::sheet)) text += "sheet: the potential's own law, with bending and no fitted number\n";
  return text;
}

}  // namespace

std::string pressed_table(const Result& result, int width) {
  std::string text;
  if (const Run* membrane = pressed(result, Model::membrane)) {
    text += heading(result, *membrane) + membrane_rows(*membrane, width);
    if (result.resolved.edge == Edge::sliding && !result.resolved.unrelaxed)
      text += "\nPull-in and wrinkled area depend on mesh and path: states of nearly equal energy differ in them.\n";
  }
  if (const Run* atoms = pressed(result, Model::atomistic)) text += atoms_rows(result, *atoms, width);
  return text;
}

}  // namespace validate
