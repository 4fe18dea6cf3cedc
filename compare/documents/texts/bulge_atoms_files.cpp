#include "compare/documents/texts/bulge_atoms_files.hpp"

#include <cmath>
#include <iterator>

#include "compare/results/keys.hpp"
#include "compare/results/result_fields.hpp"

namespace validate {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json json_of(const std::optional<double>& value) { return value ? json_of(*value) : Json(nullptr); }
template <class Value>
Json json_of(const Value& value) {
  return value;
}

template <class Struct>
Json object_of(const Struct& s) {
  Json object = Json::object();
  describe_with_twins(s, [&](const Field& field, const auto& value) { object[key(field)] = json_of(value); });
  return object;
}

}  // namespace

Json bulge_atoms_document(const BulgeAtoms& atoms) {
  Json document;
  document["card"] = object_of(atoms.card);
  document["atoms"] = atoms.atoms;
  document["free_atoms"] = atoms.free_atoms;
  document["membrane_size_x_A"] = atoms.membrane_size_x_A;
  document["membrane_size_y_A"] = atoms.membrane_size_y_A;
  document["points"] = Json::array();
  for (const BulgeAtomsPoint& point : atoms.points) document["points"].push_back(object_of(point));
  document["ended"] = to_string(atoms.ended);
  document["ended_reason"] = atoms.ended_reason;
  return document;
}

std::string bulge_atoms_csv(const BulgeAtoms& atoms) {
  const BulgeAtomsPoint empty;
  std::string header, rows;
  describe(empty, [&](const Field& field, const auto&) { header += (header.empty() ? "" : ",") + key(field); });
  for (const BulgeAtomsPoint& point : atoms.points) {
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
  return "# validate bulge: atoms beside the membrane\n" + header + "\n" + rows;
}

std::string bulge_atoms_table(const BulgeAtoms& atoms) {
  std::string text = fmt::format("\n{} atoms; membrane of {:.2f} × {:.2f} Å with the card's constants\n\n", atoms.atoms,
                                 atoms.membrane_size_x_A, atoms.membrane_size_y_A);
  text +=
      "  pressure   atoms' depth   membrane's    ratio     sheet's    ratio  longest bond  evaluations\n"
      "    eV/Å³          Å             Å                    Å                    Å\n";
  const auto shown = [](double value, int width, int digits) {
    return std::isfinite(value) ? fmt::format("{:{}.{}f}", value, width, digits) : fmt::format("{:>{}}", "–", width);
  };
  for (const BulgeAtomsPoint& p : atoms.points)
    text += fmt::format("{:10.4e} {:12.3f} {:13.3f} {:10.4f} {} {} {:11.4f} {:10}{}{}\n", p.pressure_eV_per_A3,
                        p.depth_A, p.membrane_depth_A, p.depth_ratio, shown(p.sheet_depth_A, 10, 3),
                        shown(p.sheet_ratio, 8, 4), p.longest_bond_A, p.force_evaluations,
                        p.artefact ? "  artefact zone" : "", p.converged ? "" : "  not converged");
  if (!atoms.points.empty() && std::isfinite(atoms.points.front().sheet_ratio))
    text += "sheet: the potential's own law, with bending and no fitted number\n";
  if (atoms.ended != Ended::depth_max)
    text += fmt::format("\natoms ended ({}): {}\n", to_string(atoms.ended), atoms.ended_reason);
  return text;
}

}  // namespace validate
