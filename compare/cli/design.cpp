#include "compare/cli/design.hpp"

#include <spdlog/spdlog.h>

#include <memory>
#include <string>

#include "atomistic/protocol/math_threads.hpp"
#include "compare/base/errors.hpp"
#include "compare/base/field_value.hpp"
#include "compare/base/file.hpp"
#include "compare/base/terminal.hpp"
#include "compare/cli/fit_flags.hpp"
#include "compare/documents/design_files.hpp"
#include "compare/documents/texts/design_text.hpp"
#include "compare/documents/texts/json.hpp"
#include "compare/fitting/design.hpp"
#include "compare/process/document_folder.hpp"
#include "compare/process/provenance.hpp"
#include "compare/results/result.hpp"

namespace validate {
namespace {

struct DesignFlags {
  FitFlags drum;  ///< radius, nu, tip, cantilever, as for a fit
  std::string modulus = "340 N/m", pretension = "0.1 N/m", depth, noise, height_noise = "0 nm", target;
  int points = 500, curves = 1;
  double before = 1;
};

double quantity(const Field& field, const std::string& text) {
  const std::string label = fmt::format("--{}", field.name);
  if (text.empty()) throw bad_input("{}: is needed: {}", label, field.meaning);
  const double value = parse_number(field, text, label);
  if (value != 0 && text.find_first_not_of("0123456789.+-eE ") == std::string::npos)
    throw bad_input("{}: '{}' has no unit; write it like \"0.5 nm\" or \"5 nN\"", label, text);
  return value;
}

/// "3 %" or 0.03.
double target_of(std::string text) {
  const auto percent = text.find('%');
  const bool in_percent = percent != std::string::npos;
  if (in_percent) text.erase(percent);
  return parse_number(Field{"target", unit::none, "", positive()}, text, "--target") / (in_percent ? 100 : 1);
}

Experiment experiment_of(const DesignFlags& flags) {
  Experiment e;
  e.options = options_of(flags.drum, MeasuredCurve{}, std::nullopt);
  if (!e.options.sphere && e.options.geometry.tip_A == 0) throw bad_input("--tip-radius: is needed by a disc");
  e.Eh_eV_per_A2 =
      quantity(Field{"Eh", unit::membrane_force, "sheet modulus that is expected", positive()}, flags.modulus);
  e.pretension_eV_per_A2 = quantity(
      Field{"pretension", unit::membrane_force, "pretension that is expected", not_negative()}, flags.pretension);
  e.depth_A = quantity(Field{"depth", unit::length, "largest depth", positive()}, flags.depth);
  if (e.depth_A > 0.4 * e.options.geometry.a_A)
    throw bad_input("--depth: {} is more than 0.4 of the drum's radius; no such sheet holds", flags.depth);
  e.noise_eV_per_A =
      quantity(Field{"noise", unit::force, "noise of the force, one standard deviation", positive()}, flags.noise);
  e.height_noise_A =
      quantity(Field{"height-noise", unit::length, "noise of the heights", not_negative()}, flags.height_noise);
  e.before = flags.before;
  e.points = flags.points;
  e.curves = flags.curves;
  if (!flags.target.empty()) e.target = target_of(flags.target);
  return e;
}

int run_design(const DesignFlags& asked) {
  DesignFlags flags = asked;
  atomistic::use_one_math_thread();
  take_settings(flags.drum);
  Result result;
  result.command = Command::design;
  result.provenance = provenance(command_line());
  result.design = design(experiment_of(flags));
  if (flags.drum.output.out) {
    OutputFolder folder(*flags.drum.output.out, flags.drum.output.overwrite);
    write_design_files(result, folder.drafts());
    folder.finish(0);
  }
  if (!flags.drum.json.empty()) write_json(result, flags.drum.json);
  if (flags.drum.json != "-") print_text(design_text(*result.design));
  return 0;
}

constexpr const char* design_examples =
    R"TXT(The interval is that of `validate fit` with contact, zero of force and tilt free, before it is measured. Inputs with an error
("0.50 ± 0.01 um") count; curves are of one drum, in one joint fit.

Examples:
  validate design --radius "0.50 ± 0.01 um" --nu 0.165 --tip-radius "16.5 ± 2 nm" --spring-constant "3.0 ± 0.2 N/m" --depth "80 nm" --noise "0.3 nN"
  validate design --settings fit.toml --depth "80 nm" --noise "0.3 nN" --curves 20 --target "3 %" --out plan)TXT";

}  // namespace

void add_design(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("design", "how well E·h will be known from an experiment, before it is made");
  const auto flags = std::make_shared<DesignFlags>();
  const auto text = [&](const char* name, std::string& value, const char* meaning, const char* type = "VALUE") {
    command->add_option(name, value, meaning)->type_name(type);
  };
  text("--radius", flags->drum.radius, "radius of the suspended sheet, with its error");
  text("--nu", flags->drum.nu, "Poisson's ratio, with its error if it has one", "NUMBER");
  text("--tip", flags->drum.tip, "shape of the tip; sphere, disc; default sphere", "NAME");
  text("--tip-radius", flags->drum.tip_radius, "radius of the tip, with its error");
  text("--spring-constant", flags->drum.spring_constant,
       "of the cantilever, with its error; without it depths are measured apart from forces");
  text("--sensitivity-error", flags->drum.sensitivity_error, "relative error of the deflection, 5 % say", "NUMBER");
  text("--settings", flags->drum.settings, "TOML file of validate fit; flags come first", "FILE");
  text("--Eh", flags->modulus, "sheet modulus that is expected; default 340 N/m");
  text("--pretension", flags->pretension, "pretension that is expected; default 0.1 N/m");
  text("--depth", flags->depth, "largest depth");
  text("--noise", flags->noise, "noise of the force, one standard deviation");
  text("--height-noise", flags->height_noise, "noise of the heights, one standard deviation; default 0");
  command->add_option("--points", flags->points, "of a curve; 20 to 1000000; default 500")
      ->type_name("N")
      ->check(CLI::Range(20, 1000000).description(""));
  command->add_option("--curves", flags->curves, "of one drum; 1 to 1000000; default 1")
      ->type_name("N")
      ->check(CLI::Range(1, 1000000).description(""));
  command->add_option("--before", flags->before, "way without contact over the way in contact; 0 to 100; default 1")
      ->type_name("NUMBER")
      ->check(CLI::Range(0.0, 100.0).description(""));
  text("--target", flags->target, "standard error of E·h that is wanted: what must change for it", "\"3 %\"");
  add_output_options(*command, flags->drum.output, "folder for design.json and the picture; default: none");
  text("--json", flags->drum.json, "write the numbers there; - is stdout", "FILE");
  command->footer(design_examples);
  command->callback([flags, &exit_code] { exit_code = run_design(*flags); });
}

}  // namespace validate
