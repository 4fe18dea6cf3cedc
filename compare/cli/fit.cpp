#include "compare/cli/fit.hpp"

#include <spdlog/spdlog.h>

#include <memory>
#include <string>
#include <vector>

#include "atomistic/protocol/math_threads.hpp"
#include "compare/base/errors.hpp"
#include "compare/base/interrupt.hpp"
#include "compare/base/paths.hpp"
#include "compare/base/terminal.hpp"
#include "compare/cli/fit_flags.hpp"
#include "compare/cli/fit_many.hpp"
#include "compare/documents/fit_files.hpp"
#include "compare/documents/texts/json.hpp"
#include "compare/documents/texts/many_text.hpp"
#include "compare/documents/texts/measured_report.hpp"
#include "compare/potential/potential_card.hpp"
#include "compare/process/document_folder.hpp"
#include "compare/process/provenance.hpp"

namespace validate {
namespace {

/// The card of the potential whose sheet is fitted.
std::optional<PotentialCard> card_of(const FitFlags& flags) {
  if (flags.potential.empty()) return std::nullopt;
  if (!flags.third_order.empty()) throw bad_input("--third-order: the potential of --potential has its own law");
  const PotentialFile file = read_potential(flags.potential, inputs_folder() / "potentials", "--potential");
  for (const std::string& warning : file.warnings) spdlog::warn("{}", warning);
  PotentialCard card =
      potential_card(file, {.program = atoms_program(), .launcher = {}, .cores = 1}, card_cache(), false);
  if (!card.law) throw bad_input("--potential: '{}' has no calibrated law: {}", flags.potential, card.no_law);
  return card;
}

std::optional<std::filesystem::path> partial_of(const FitFlags& flags) {
  if (!flags.output.out) {
    if (flags.resume) throw bad_input("--resume: needs the --out that was begun");
    return std::nullopt;
  }
  std::filesystem::path file = std::filesystem::absolute(*flags.output.out).lexically_normal();
  if (!file.has_filename()) file = file.parent_path();
  return file += ".partial.csv";
}

void print_all(const Result& result) {
  for (const FittedCurve& curve : result.curves) print_text(measured_text(curve) + "\n");
  if (result.many) print_text(many_text(*result.many));
}

int fit(FitFlags flags) {
  take_settings(flags);
  catch_interrupts();
  atomistic::use_one_math_thread();
  Result result;
  result.command = Command::fit;
  result.provenance = provenance(command_line());
  const std::optional<PotentialCard> card = card_of(flags);
  // Everything is read and checked before anything is written.
  fit_curves(flags, card, partial_of(flags), result);
  if (flags.output.out) {
    OutputFolder folder(*flags.output.out, flags.output.overwrite);
    write_fit_files(result, folder.drafts());
    folder.finish(0);
  }
  if (!flags.json.empty()) write_json(result, flags.json);
  if (flags.json != "-") print_all(result);
  return 0;
}

constexpr const char* fit_examples =
    R"TXT(A file is an instrument's (validate curve --help lists the formats) or a table with units in its header:
depth_nm,force_nN or "depth (nm)", "force [nN]". Lines of the form
"# radius: 0.5 um" (also nu, tip, tip-radius) stand in for flags that are not given. validate model lists the models.
Of more than 20 curves each is a row of curves.csv, without a drawing of its own; on all cores.
Tables of --settings: [hole] radius; [tip] tip, tip-radius; [cantilever] spring-constant, sensitivity, sensitivity-error;
[sheet] nu, bending, potential, third-order; [fit] all others. Values are texts like the flags': radius = "0.50 ± 0.01 um".

Examples:
  validate fit curve.csv --radius "0.5 um" --nu 0.165 --tip-radius "16.5 nm"
  validate fit *.csv --radius "0.50 ± 0.01 um" --nu 0.165 --tip-radius "16.5 ± 2 nm" --contact fit --out fits
  validate fit runs/indentation-airebo-R110/curves.csv --run 1 --radius "110 A" --nu 0.36 --tip disc --tip-radius "10 A"
  validate fit map.jpk-force-map --radius "0.5 um" --nu 0.165 --tip-radius "16.5 nm" --out map
  validate fit folder --settings fit.toml --out drums --resume
  validate fit curve.csv --radius "0.5 um" --tip disc --tip-radius "16.5 nm" --potential lcbop
  validate fit curve.csv --radius "0.5 um" --nu 0.165 --tip-radius "16.5 nm" --third-order "-690 N/m" --bending 1.4
  validate fit curve.csv --radius "0.5 um" --nu 0.165 --model foeppl --tip disc --weights relative --json -)TXT";

}  // namespace

void add_fit(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("fit", "E·h and pretension of measured force-depth curves");
  const auto flags = std::make_shared<FitFlags>();
  command->add_option("files", flags->files, "measured curves, of any format of validate curve, or folders of them")
      ->required()
      ->type_name("FILE");
  const auto text = [&](const char* name, std::string& value, const char* meaning, const char* type = "VALUE") {
    command->add_option(name, value, meaning)->type_name(type);
  };
  text("--radius", flags->radius, "radius of the suspended sheet, with its error: \"0.50 ± 0.01 um\"; > 0 Å");
  text("--nu", flags->nu, "Poisson's ratio, with its error if it has one; > -1 and < 1", "NUMBER");
  text("--tip", flags->tip, "shape of the tip; sphere, disc; default sphere", "NAME");
  text("--tip-radius", flags->tip_radius, "radius of the tip, with its error; 0 is a point; default 0");
  text("--bending", flags->bending, "bending modulus in eV, for the model plate, the warnings and the sheet", "NUMBER");
  text("--potential", flags->potential, "fit a sheet of this potential's own law, with bending, beside the closed form",
       "NAME");
  text("--third-order", flags->third_order, "fit a sheet with S = E·h E + D E²: this D, -690 N/m in Lee et al. 2008");
  text("--model", flags->model, "closed form to fit; default eq16", "NAME");
  text("--weights", flags->weights,
       "noise of the points: the file's sigma if it has one, alike, in proportion to the force, or the file's; "
       "automatic, uniform, relative, sigma; default automatic",
       "NAME");
  text("--depth-column", flags->depth_column, "header or number of the depth column", "NAME");
  text("--force-column", flags->force_column, "header or number of the force column", "NAME");
  text("--sigma-column", flags->sigma_column, "header or number of the forces' standard deviations", "NAME");
  text("--sigma-force", flags->sigma_force, "noise of the forces, one standard deviation; default: estimated");
  text("--sigma-depth", flags->sigma_depth, "noise of the depths; default: estimated where there are 40 points");
  text("--spring-constant", flags->spring_constant,
       "of the cantilever, with its error: all forces are in proportion to it; turns heights into depths");
  text("--sensitivity", flags->sensitivity, "of the deflection, where a file has it in V (m/V) or A (m/A)");
  text("--run", flags->curves,
       "of a file with several curves these alone: runs of a curves.csv, numbers of a map; default all", "N,...");
  text("--segment", flags->segment, "which is fitted; approach, retract, pause; default approach", "NAME");
  text("--sensitivity-error", flags->sensitivity_error, "relative error of the deflection, 5 % say", "NUMBER");
  text("--depth-min", flags->depth_min, "smallest depth used");
  text("--depth-max", flags->depth_max, "largest depth used");
  text("--baseline", flags->baseline,
       "taken off the forces: tilt, a line before the contact; level; none; or the mean up to this depth; default tilt "
       "for instruments' curves, none for tables",
       "NAME|VALUE");
  text("--contact", flags->contact,
       "depth of the contact point, or 'fit' to find it and the zero of force with the rest; default 0");
  command->add_flag("--fit-force-zero", flags->fit_force_zero, "the zero of force is one more parameter");
  command->add_flag("--fit-slope", flags->fit_slope, "and so is a slope of the baseline");
  command
      ->add_option("--bootstrap", flags->bootstrap, "check the errors by refits to drawn noise; 0 to 100000; default 0")
      ->type_name("N")
      ->check(CLI::Range(0, 100000).description(""));
  command->add_option("--seed", flags->seed, "of the draws; default 1")->type_name("N");
  text("--settings", flags->settings, "TOML file with the same names as keys; flags come first", "FILE");
  command->add_flag("--resume", flags->resume, "go on with the curves of an --out that was not finished");
  command->add_flag("--quiet", flags->quiet, "no progress");
  add_output_options(*command, flags->output, "folder for plots and fit.json; default: none");
  text("--json", flags->json, "write the numbers there; - is stdout", "FILE");
  command->footer(fit_examples);
  command->callback([flags, &exit_code] { exit_code = fit(*flags); });
}

}  // namespace validate
