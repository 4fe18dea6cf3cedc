#include "compare/documents/bulge_result.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>

#include "compare/base/file.hpp"
#include "compare/documents/bytes/vtu.hpp"
#include "compare/documents/fields_h5.hpp"
#include "compare/documents/plots/bulge_atoms_plot.hpp"
#include "compare/documents/plots/draw.hpp"
#include "compare/documents/plots/sheet_maps.hpp"
#include "compare/documents/texts/bulge_atoms_files.hpp"
#include "compare/results/keys.hpp"
#include "compare/results/result_fields.hpp"

namespace validate {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json json_of(const std::string& value) { return value.empty() ? Json(nullptr) : Json(value); }
template <class Value>
Json json_of(const Value& value) {
  return value;
}

template <class Struct>
Json object_of(const Struct& s) {
  Json object = Json::object();
  describe_with_twins(s, [&](const Field& field, const auto& value) {
    if constexpr (std::is_constructible_v<Json, decltype(value)>) object[key(field)] = json_of(value);
  });
  return object;
}

/// How far the middle of the right edge has come in; without a square's edge nothing is known.
double pull_in(const SheetPicture& picture) {
  const membrane::Mesh& mesh = picture.mesh;
  if (!mesh.edges.contains(membrane::Edge::right)) return not_known;
  const auto& edge = mesh.edges.at(membrane::Edge::right);
  const int middle = *std::min_element(edge.begin(), edge.end(), [&](int a, int b) {
    return std::abs(mesh.nodes[a].y()) < std::abs(mesh.nodes[b].y());
  });
  return -picture.displacement[3 * middle];
}

void write_h5(const BulgeResult& result, const std::filesystem::path& folder) {
  PendingFile pending(folder / "run.h5");
  h5::File file(pending.path());
  {
    h5::Group& root = file.root();
    root.attribute("meaning", "a sheet under follower pressure: fields per pressure; keys as in summary.json");
    root.attribute("summary", bulge_document(result).dump());
    h5::Group fields = root.group("fields");
    for (std::size_t i = 0; i < result.pictures.size(); ++i)
      write_fields(fields, std::to_string(i), result.pictures[i]);
  }
  file.close();
  pending.commit();
}

void write_csv(const BulgeResult& result, const std::filesystem::path& folder) {
  const BulgePoint empty;
  std::string header, rows;
  describe(empty, [&](const Field& field, const auto&) { header += (header.empty() ? "" : ",") + key(field); });
  for (const BulgePoint& point : result.points) {
    std::string row;
    describe(point, [&](const Field&, const auto& value) {
      row += (row.empty() ? "" : ",");
      if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, double>)
        row += std::isfinite(value) ? fmt::format("{}", value) : "";
      else
        row += fmt::format("{:d}", value);
    });
    rows += row + "\n";
  }
  write_file(folder / "curves.csv", "# validate bulge\n" + header + "\n" + rows);
}

}  // namespace

BulgePoint bulge_point(const membrane::Step& step, const SheetPicture& picture) {
  const auto& larger = column(picture.triangles, "cauchy_1_eV_per_A3");
  const auto& smaller = column(picture.triangles, "cauchy_2_eV_per_A3");
  return {.pressure_eV_per_A3 = step.pressure_eV_per_A3,
          .depth_A = step.depth_A,
          .volume_A3 = step.volume_A3,
          .energy_eV = step.energy_eV,
          .converged = step.converged,
          .wrinkled_area_fraction = total(picture.totals, "wrinkled_area_fraction"),
          .slack_area_fraction = total(picture.totals, "slack_area_fraction"),
          .edge_pull_in_A = pull_in(picture),
          .stress_1_max_eV_per_A3 = *std::max_element(larger.begin(), larger.end()),
          .stress_2_min_eV_per_A3 = *std::min_element(smaller.begin(), smaller.end()),
          .stress_2_max_eV_per_A3 = *std::max_element(smaller.begin(), smaller.end()),
          .newton_iterations = step.newton_iterations};
}

Json bulge_case_document(const BulgeCase& c) { return object_of(c); }

Json bulge_document(const BulgeResult& result) {
  Json document;
  document["schema"] = 1;
  document["command"] = "bulge";
  document["case"] = bulge_case_document(result.resolved);
  document["points"] = Json::array();
  for (const BulgePoint& point : result.points) document["points"].push_back(object_of(point));
  if (result.atoms) document["atoms"] = bulge_atoms_document(*result.atoms);
  document["ended"] = result.converged ? "pressure_max" : "not_converged";
  document["ended_reason"] = result.ended_reason;
  document["triangles"] = result.triangles;
  document["factorisations"] = result.factorisations;
  document["wall_s"] = result.wall_s;
  document["provenance"] = object_of(result.provenance);
  return document;
}

void write_bulge(const BulgeResult& result, const std::filesystem::path& folder) {
  write_h5(result, folder);
  write_csv(result, folder);
  write_file(folder / "summary.json",
             bulge_document(result).dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
  write_pvd(result.pictures, folder, "membrane");
  if (result.atoms) {
    write_file(folder / "atoms.csv", bulge_atoms_csv(*result.atoms));
    if (const auto warning = write_plot(bulge_atoms_plot(*result.atoms), folder, "atoms", "atoms-figure"))
      spdlog::warn("{}", *warning);
  }
  if (result.pictures.empty()) return;
  if (const auto warning = write_plot(sheet_plot(result.pictures.back()), folder, "figure"))
    spdlog::warn("{}", *warning);
}

std::string bulge_table(const BulgeResult& result) {
  const BulgeCase& c = result.resolved;
  std::string text = fmt::format(
      "{} of {:g} Å, edge {}, E·h = {:.4g} eV/Å² ({:.4g} N/m), nu = {:g}, {} triangles on the {}{}\n\n", c.shape,
      c.size_A, c.edge, c.E_eV_per_A3 * c.thickness_A, c.E_eV_per_A3 * c.thickness_A * N_per_m_per_eV_per_A2, c.nu,
      result.triangles, c.extent == "quarter" ? "quarter" : "full sheet", c.unrelaxed ? ", compression allowed" : "");
  text +=
      "  pressure     centre      volume  wrinkled  slack  pull-in   max stress   min stress of 2nd    max of 2nd\n"
      "    eV/Å³          Å          Å³         %      %        Å        eV/Å³         eV/Å³           eV/Å³\n";
  for (const BulgePoint& p : result.points)
    text += fmt::format("{:10.4e} {:10.3f} {:11.5g} {:9.1f} {:6.1f} {:8.2f} {:12.5f} {:15.5f} {:15.5f}{}\n",
                        p.pressure_eV_per_A3, p.depth_A, p.volume_A3, 100 * p.wrinkled_area_fraction,
                        100 * p.slack_area_fraction, p.edge_pull_in_A, p.stress_1_max_eV_per_A3,
                        p.stress_2_min_eV_per_A3, p.stress_2_max_eV_per_A3, p.converged ? "" : "  not converged");
  if (c.edge == "sliding" && !c.unrelaxed)
    text += "\nPull-in and wrinkled area depend on mesh and path: states of nearly equal energy differ in them.\n";
  if (result.atoms) text += bulge_atoms_table(*result.atoms);
  return text;
}

}  // namespace validate
