#include "compare/documents/texts/pressed_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "compare/base/units.hpp"

namespace validate {
namespace {

const Run* pressed(const Result& result, Model model) {
  const auto found = std::ranges::find_if(
      result.runs, [&](const Run& run) { return run.load == LoadKind::pressure && run.model == model; });
  return found == result.runs.end() ? nullptr : &*found;
}

/// A number, or a dash where it is not known.
std::string shown(double value, const char* format, int width) {
  return fmt::format("{:>{}}", std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "-", width);
}

std::string heading(const Result& result, const Run& run) {
  const Case& c = result.resolved;
  return fmt::format("{} of {:g} Å, edge {}, E·h = {:.4g} eV/Å² ({:.4g} N/m), nu = {:g}, {} triangles on the {}{}\n\n",
                     c.shape, 2 * c.radius_A, c.edge, run.Eh_eV_per_A2, run.Eh_eV_per_A2 * N_per_m_per_eV_per_A2,
                     run.nu, run.continuum().triangles, c.extent == Extent::quarter ? "quarter" : "full sheet",
                     c.unrelaxed ? ", compression allowed" : "");
}

std::string membrane_rows(const Run& run) {
  std::string text =
      "  pressure     centre      volume  wrinkled  slack  pull-in   max stress   min stress of 2nd    max of 2nd\n"
      "    eV/Å³          Å          Å³         %      %        Å        eV/Å³         eV/Å³           eV/Å³\n";
  const ContinuumPart& part = run.continuum();
  for (std::size_t i = 0; i < run.depth_A.size(); ++i)
    fmt::format_to(
        std::back_inserter(text), "{:10.4e} {:10.3f} {:11.5g} {:9.1f} {:6.1f} {} {:12.5f} {:15.5f} {:15.5f}{}\n",
        run.pressure_eV_per_A3[i], run.depth_A[i], run.volume_A3[i], 100 * part.wrinkled_area_fraction[i],
        100 * part.slack_area_fraction[i], shown(part.edge_pull_in_A[i], "{:.2f}", 8), part.stress_1_max_eV_per_A3[i],
        part.stress_2_min_eV_per_A3[i], part.stress_2_max_eV_per_A3[i], run.converged[i] ? "" : "  not converged");
  return text;
}

std::string atoms_rows(const Result& result, const Run& atoms) {
  const auto found = std::ranges::find(result.comparisons, LoadKind::pressure, &Comparison::load);
  if (found == result.comparisons.end()) return {};
  const Comparison& c = *found;
  std::string text =
      "\n  pressure   atoms' depth   membrane's    ratio     sheet's    ratio  longest bond  evaluations\n"
      "    eV/Å³          Å             Å                    Å                    Å\n";
  for (std::size_t i = 0; i < atoms.depth_A.size(); ++i) {
    const auto at = std::ranges::find(c.depth_A, atoms.depth_A[i]) - c.depth_A.begin();
    const auto k = static_cast<std::size_t>(at);
    const bool known = k < c.depth_A.size();
    const double depth = atoms.depth_A[i], ratio = known ? c.depth_ratio[k] : not_known,
                 sheet = known ? c.sheet_depth_ratio[k] : not_known;
    fmt::format_to(std::back_inserter(text), "{:10.4e} {:12.3f} {} {} {} {} {:11.4f} {:10d}{}\n",
                   atoms.pressure_eV_per_A3[i], depth, shown(depth / ratio, "{:.3f}", 13), shown(ratio, "{:.4f}", 11),
                   shown(depth / sheet, "{:.3f}", 10), shown(sheet, "{:.4f}", 8), atoms.longest_bond_A[i],
                   atoms.atoms().force_evaluations[i], atoms.converged[i] ? "" : "  not converged");
  }
  if (pressed(result, Model::sheet)) text += "sheet: the potential's own law, with bending and no fitted number\n";
  return text;
}

}  // namespace

std::string pressed_table(const Result& result) {
  std::string text;
  if (const Run* membrane = pressed(result, Model::membrane)) {
    text += heading(result, *membrane) + membrane_rows(*membrane);
    if (result.resolved.edge == Edge::sliding && !result.resolved.unrelaxed)
      text += "\nPull-in and wrinkled area depend on mesh and path: states of nearly equal energy differ in them.\n";
  }
  if (const Run* atoms = pressed(result, Model::atomistic)) text += atoms_rows(result, *atoms);
  return text;
}

}  // namespace validate
