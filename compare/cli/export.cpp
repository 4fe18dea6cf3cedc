#include "compare/cli/export.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "atomistic/protocol/math_threads.hpp"
#include "compare/base/errors.hpp"
#include "compare/base/field_value.hpp"
#include "compare/base/file.hpp"
#include "compare/base/standard_streams.hpp"
#include "compare/cli/fit_flags.hpp"
#include "compare/documents/texts/nanite_model.hpp"
#include "compare/fitting/measured_fit.hpp"
#include "compare/process/provenance.hpp"

namespace validate {
namespace {

struct ExportFlags {
  FitFlags drum;
  std::string what, out;
};

constexpr double m_per_A = 1e-10;
/// Shares of the radius and of the sheet modulus that the table reaches: what a sheet of graphene bears.
constexpr double shallowest = 2e-4, deepest = 0.3, most_pretension = 0.02;
constexpr int depths = 121, pretensions = 17;

SheetForces forces_of(const MeasuredOptions& options) {
  const double a = options.geometry.a_A, any_Eh = 20;
  const ForceModel model = sheet_model(options, std::nullopt, {deepest * a, any_Eh, most_pretension}).model;
  SheetForces sheet;
  sheet.radius_m = m_per_A * a;
  sheet.nu = options.geometry.nu;
  sheet.tip_radius_m = m_per_A * options.geometry.tip_A;
  sheet.tip = options.geometry.tip_A == 0 ? "point" : options.sphere ? "sphere" : "disc";
  sheet.relative_error = model.relative_error;
  sheet.first_log_depth = std::log(shallowest);
  sheet.step_log_depth = std::log(deepest / shallowest) / (depths - 1);
  sheet.scale = 1e-6;  // where even the shallowest part of the table knows no pretension
  sheet.step_v = std::log1p(most_pretension / sheet.scale) / (pretensions - 1);
  for (int j = 0; j < pretensions; ++j) {
    const double s = sheet.scale * std::expm1(j * sheet.step_v);
    std::vector<double>& row = sheet.log_force.emplace_back();
    for (int i = 0; i < depths; ++i) {
      const double d = a * std::exp(sheet.first_log_depth + i * sheet.step_log_depth);
      row.push_back(std::log(model.at(d, any_Eh, s * any_Eh).force / (any_Eh * a)));
    }
  }
  return sheet;
}

int run_export(const ExportFlags& asked) {
  ExportFlags flags = asked;
  if (flags.what != "nanite") throw bad_input("export: unknown '{}'; allowed: nanite", flags.what);
  atomistic::use_one_math_thread();
  take_settings(flags.drum);
  const std::string text =
      nanite_model(forces_of(options_of(flags.drum, MeasuredCurve{}, std::nullopt)), command_line());
  if (flags.out.empty() || flags.out == "-")
    print_result(text);
  else
    write_file(flags.out, text);
  return 0;
}

constexpr const char* export_examples =
    R"TXT(nanite: a Python module that nanite and PyJibe load as a model: the membrane of finite strain with its real tip, as a
table of forces up to 0.3 of the radius and a pretension of 0.02 E·h.

Example:
  validate export nanite --radius "500 nm" --nu 0.165 --tip-radius "16.5 nm" --out suspended_sheet.py)TXT";

}  // namespace

void add_export(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("export", "the sheet with its tip as a model for nanite and PyJibe");
  const auto flags = std::make_shared<ExportFlags>();
  command->add_option("what", flags->what, "nanite")->required()->type_name("NAME");
  const auto text = [&](const char* name, std::string& value, const char* meaning, const char* type = "VALUE") {
    command->add_option(name, value, meaning)->type_name(type);
  };
  text("--radius", flags->drum.radius, "radius of the suspended sheet");
  text("--nu", flags->drum.nu, "Poisson's ratio; > -1 and < 1", "NUMBER");
  text("--tip", flags->drum.tip, "shape of the tip; sphere, disc; default sphere", "NAME");
  text("--tip-radius", flags->drum.tip_radius, "radius of the tip; 0 is a point; default 0");
  text("--settings", flags->drum.settings, "TOML file of validate fit; flags come first", "FILE");
  text("--out", flags->out, "the file to write; default stdout", "FILE");
  command->footer(export_examples);
  command->callback([flags, &exit_code] { exit_code = run_export(*flags); });
}

}  // namespace validate
