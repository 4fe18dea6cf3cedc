#include "compare/documents/texts/bulge_atoms_files.hpp"

#include <cmath>
#include <iterator>

#include "compare/documents/plots/figure.hpp"
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

std::string block(const char* name, const std::vector<double>& x, const std::vector<double>& y) {
  std::string text = fmt::format("${} << EOD\n", name);
  for (std::size_t i = 0; i < x.size(); ++i) fmt::format_to(std::back_inserter(text), "{:.6g} {:.6g}\n", x[i], y[i]);
  return text + "EOD\n";
}

/// Depth against pressure, both logarithmic: a membrane's is a line of slope 1/3.
std::string curve_commands(const BulgeAtoms& atoms) {
  std::vector<double> pressure, depth, membrane;
  for (const BulgeAtomsPoint& p : atoms.points) {
    if (!std::isfinite(p.membrane_depth_A)) continue;
    pressure.push_back(p.pressure_eV_per_A3);
    depth.push_back(p.depth_A);
    membrane.push_back(p.membrane_depth_A);
  }
  return block("atoms", pressure, depth) + block("membrane", pressure, membrane) +
         "set title 'depth of the centre'\nset logscale xy\nset format x '%.1te%T'\nset xlabel 'pressure (eV/Å³)'\n"
         "set ylabel 'depth (Å)'\nset xrange [*:*] noextend\nset key left top Left reverse\n"
         "plot $membrane with lines lw 1.5 lc rgb '#0072B2' title 'membrane', "
         "$atoms with points pt 7 ps 0.8 lc rgb '#D55E00' title 'atoms'\n"
         "unset logscale\nset format x '%g'\n";
}

std::string profile_commands(const BulgeAtoms& atoms) {
  return block("atoms_profile", atoms.atoms_profile.x_A, atoms.atoms_profile.z_A) +
         block("membrane_profile", atoms.membrane_profile.x_A, atoms.membrane_profile.z_A) +
         fmt::format("set title 'cross-section at {:.4g} eV/Å³'\n", atoms.points.back().pressure_eV_per_A3) +
         "set autoscale\nset yrange [*:0]\nset xlabel 'x (Å)'\nset ylabel 'z (Å)'\nset key center top Left reverse\n"
         "plot $membrane_profile with lines lw 1.5 lc rgb '#0072B2' title 'membrane', "
         "$atoms_profile with points pt 7 ps 0.35 lc rgb '#D55E00' title 'atoms'\n";
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

std::optional<std::string> draw_bulge_atoms(const BulgeAtoms& atoms, const std::filesystem::path& folder) {
  if (atoms.points.empty() || atoms.membrane_profile.x_A.empty()) return std::nullopt;
  const bool curve = atoms.points.size() > 1;
  std::string commands =
      fmt::format("set multiplot layout 1,{}\nset border 3\nset tics nomirror out\nset grid lc rgb '#e4e4e4' lt 1\n",
                  curve ? 2 : 1);
  if (curve) commands += curve_commands(atoms);
  commands += profile_commands(atoms) + "unset multiplot\n";
  return draw(commands, folder, "atoms", {curve ? 1000 : 700, 380});
}

}  // namespace validate
