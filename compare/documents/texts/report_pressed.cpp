// A sheet under pressures, as tables of a page.
#include <fmt/format.h>

#include <algorithm>

#include "compare/documents/bytes/html.hpp"
#include "compare/documents/texts/numbers.hpp"
#include "compare/documents/texts/report_tables.hpp"

namespace validate {
namespace {

using Rows = std::vector<std::vector<std::string>>;

const Run* pressed(const Result& result, Model model) {
  const auto found = std::ranges::find_if(
      result.runs, [&](const Run& run) { return run.load == LoadKind::pressure && run.model == model; });
  return found == result.runs.end() ? nullptr : &*found;
}

std::string pressed_membrane(const Result& result, const Run& run) {
  const Case& c = result.resolved;
  const ContinuumPart& part = run.continuum();
  Rows rows;
  for (std::size_t i = 0; i < run.depth_A.size(); ++i)
    rows.push_back({number(run.pressure_eV_per_A3[i], "{:.4e}"), number(run.depth_A[i], "{:.3f}"),
                    number(run.volume_A3[i], "{:.5g}"), number(100 * part.wrinkled_area_fraction[i], "{:.1f}"),
                    number(100 * part.slack_area_fraction[i], "{:.1f}"), number(part.edge_pull_in_A[i], "{:.2f}"),
                    number(part.stress_1_max_eV_per_A3[i], "{:.5f}"), number(part.stress_2_min_eV_per_A3[i], "{:.5f}"),
                    number(part.stress_2_max_eV_per_A3[i], "{:.5f}"), run.converged[i] ? "yes" : "no"});
  return fmt::format("<h2>{} of {:g} Å, edge {}: the membrane</h2>\n", to_string(c.shape), 2 * c.radius_A,
                     to_string(c.edge)) +
         fmt::format("<p class=\"soft\">E·h = {} N/m, ν = {:g}, {} triangles on the {}.</p>\n",
                     number(in_N_per_m(run.Eh_eV_per_A2), "{:.4g}"), run.nu, part.triangles,
                     c.extent == Extent::quarter ? "quarter" : "full sheet") +
         html::table({"pressure (eV/Å³)", "centre (Å)", "volume (Å³)", "wrinkled (%)", "slack (%)", "pull-in (Å)",
                      "largest stress (eV/Å³)", "smallest of the 2nd", "largest of the 2nd", "converged"},
                     rows);
}

std::string pressed_atoms(const Result& result, const Run& atoms) {
  const auto found = std::ranges::find(result.comparisons, LoadKind::pressure, &Comparison::load);
  if (found == result.comparisons.end()) return {};
  Rows rows;
  for (std::size_t i = 0; i < atoms.depth_A.size(); ++i) {
    const auto k =
        static_cast<std::size_t>(std::ranges::find(found->depth_A, atoms.depth_A[i]) - found->depth_A.begin());
    const bool known = k < found->depth_A.size();
    const double depth = atoms.depth_A[i], ratio = known ? found->depth_ratio[k] : not_known,
                 sheet = known ? found->sheet_depth_ratio[k] : not_known;
    rows.push_back({number(atoms.pressure_eV_per_A3[i], "{:.4e}"), number(depth, "{:.3f}"),
                    number(depth / ratio, "{:.3f}"), number(ratio, "{:.4f}"), number(depth / sheet, "{:.3f}"),
                    number(sheet, "{:.4f}"), number(atoms.longest_bond_A[i], "{:.4f}"),
                    atoms.converged[i] ? "yes" : "no"});
  }
  return std::string("<h2>Atoms beside it</h2>\n") +
         html::table({"pressure (eV/Å³)", "atoms' depth (Å)", "membrane's", "ratio", "sheet's", "ratio",
                      "longest bond (Å)", "converged"},
                     rows);
}

}  // namespace

std::string pressed_tables(const Result& result) {
  std::string text;
  if (const Run* membrane = pressed(result, Model::membrane)) {
    text += pressed_membrane(result, *membrane);
    if (result.resolved.edge == Edge::sliding && !result.resolved.unrelaxed)
      text +=
          "<p class=\"soft\">Pull-in and wrinkled area depend on mesh and path: states of nearly equal energy differ "
          "in "
          "them.</p>\n";
  }
  if (const Run* atoms = pressed(result, Model::atomistic)) text += pressed_atoms(result, *atoms);
  return text;
}

}  // namespace validate
