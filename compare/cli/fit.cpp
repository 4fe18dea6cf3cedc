#include "compare/cli/fit.hpp"

#include <spdlog/spdlog.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "atomistic/protocol/math_threads.hpp"
#include "compare/base/errors.hpp"
#include "compare/base/field_value.hpp"
#include "compare/base/file.hpp"
#include "compare/base/paths.hpp"
#include "compare/base/standard_streams.hpp"
#include "compare/cli/flags.hpp"
#include "compare/documents/fit_files.hpp"
#include "compare/documents/texts/json.hpp"
#include "compare/documents/texts/measured_report.hpp"
#include "compare/fitting/measured_fit.hpp"
#include "compare/instruments/measured.hpp"
#include "compare/instruments/si_quantity.hpp"
#include "compare/potential/potential_card.hpp"
#include "compare/process/document_folder.hpp"
#include "compare/process/provenance.hpp"

namespace validate {
namespace {

constexpr std::array<std::string_view, 2> tip_names = {"sphere", "disc"};
constexpr std::array<std::string_view, 4> weight_names = {"automatic", "uniform", "relative", "sigma"};

/// The flags as they were typed; a key of the file's remarks stands in for one that was not.
struct FitFlags {
  std::vector<std::string> files;
  std::string radius, nu, tip, tip_radius, bending, model = "eq16", weights = "automatic";
  std::string depth_column, force_column, sigma_column;
  std::string depth_min, depth_max, baseline, contact;
  std::string potential, third_order;
  std::string sigma_force, sigma_depth, spring_constant, sensitivity, sensitivity_error, segment = "approach";
  bool fit_force_zero = false, fit_slope = false;
  int bootstrap = 0;
  unsigned seed = 1;
  OutputOptions output;
  std::string json;
  std::vector<int> curves;
};

/// Value of a flag, or of the remark of the same name in the file.
struct Given {
  std::string text, label;
};

Given given(const std::string& flag, const std::string& value, const MeasuredCurve& curve) {
  if (!value.empty()) return {value, "--" + flag};
  const auto remark = curve.remarks.find(flag);
  if (remark == curve.remarks.end()) return {"", "--" + flag};
  return {remark->second, fmt::format("{}: remark {}", curve.file.string(), flag)};
}

/// A quantity of a laboratory: a number alone could be meant in any unit.
Uncertain with_unit(const Field& field, const Given& value) {
  const auto [number, error] = parse_uncertain(field, value.text, value.label);
  const bool bare = value.text.find_first_not_of("0123456789.+-eE ±%/") == std::string::npos;
  if (bare && !field.unit.empty() && number != 0)
    throw bad_input("{}: '{}' has no unit; write it like \"0.5 um\" or \"5 nN\"", value.label, value.text);
  return {number, error};
}

Uncertain need(const Field& field, const Given& value) {
  if (value.text.empty())
    throw bad_input("{}: is needed: {}, as a flag or as a remark '# {}: …' in the file", value.label, field.meaning,
                    field.name);
  return with_unit(field, value);
}

Weighting weighting(const std::string& name) {
  const std::string chosen = parse_text(Field{.name = "weights", .choices = weight_names}, name, "--weights");
  return chosen == "relative"  ? Weighting::relative
         : chosen == "sigma"   ? Weighting::sigma
         : chosen == "uniform" ? Weighting::uniform
                               : Weighting::automatic;
}

std::optional<double> known(const Field& field, const std::string& flag) {
  if (flag.empty()) return std::nullopt;
  return with_unit(field, {flag, fmt::format("--{}", field.name)}).value;
}

/// "5 %" or 0.05.
double share(std::string text, const char* label) {
  const auto percent = text.find('%');
  if (percent != std::string::npos) text.erase(percent);
  const double number = parse_number(Field{"share", unit::none, "", not_negative()}, text, label);
  return percent == std::string::npos ? number : number / 100;
}

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

/// What the sheet that is fitted itself is made of; absent: the paper's membrane.
std::optional<SheetPhysics> physics_of(const FitFlags& flags, const std::optional<PotentialCard>& card,
                                       const ModelGeometry& geometry) {
  if (card) {
    const double bending = flags.bending.empty() ? card->card.bending_modulus_eV() : geometry.bending_eV;
    return calibrated_physics(card->law->law, bending, card->potential.potential.name);
  }
  if (flags.third_order.empty()) return std::nullopt;
  const double D =
      parse_number(Field{"third-order", unit::membrane_force, "", any_number()}, flags.third_order, "--third-order");
  return third_order_physics(geometry.nu, D, geometry.bending_eV);
}

MeasuredOptions options_of(const FitFlags& flags, const MeasuredCurve& curve,
                           const std::optional<PotentialCard>& card) {
  MeasuredOptions o;
  const auto take = [&o](double ModelGeometry::*member, const Uncertain& u) {
    o.geometry.*member = u.value;
    o.errors.geometry.*member = u.error;
  };
  take(&ModelGeometry::a_A, need(Field{"radius", unit::length, "radius of the suspended sheet", positive()},
                                 given("radius", flags.radius, curve)));
  const Given nu = given("nu", flags.nu, curve);
  const bool from_card = card && flags.nu.empty();
  take(&ModelGeometry::nu,
       from_card ? Uncertain{card->card.nu()} : need(Field{"nu", unit::none, "Poisson's ratio", between(-1, 1)}, nu));
  const Given tip = given("tip-radius", flags.tip_radius, curve);
  if (!tip.text.empty())
    take(&ModelGeometry::tip_A, with_unit(Field{"tip-radius", unit::length, "", not_negative()}, tip));
  const double widest = o.geometry.tip_A + o.errors.geometry.tip_A;
  if (!(widest < o.geometry.a_A))
    throw bad_input("{}: a tip of {:g} Å is wider than the sheet of {:g} Å", tip.label, widest, o.geometry.a_A);
  if (!flags.bending.empty())
    take(&ModelGeometry::bending_eV,
         parse_uncertain(Field{"bending", unit::none, "", not_negative()}, flags.bending, "--bending"));
  const Given spring = given("spring-constant", flags.spring_constant, curve);
  if (!spring.text.empty()) {
    const Uncertain k = with_unit(Field{"spring-constant", unit::membrane_force, "", positive()}, spring);
    o.spring_constant_eV_per_A2 = k.value;
    o.errors.force_scale_relative = k.error / k.value;
  } else {
    o.spring_constant_eV_per_A2 = curve.spring_constant_eV_per_A2;
  }
  if (!flags.sensitivity_error.empty())
    o.errors.sensitivity_relative = share(flags.sensitivity_error, "--sensitivity-error");
  o.sigma_force_eV_per_A = known(Field{"sigma-force", unit::force, "", positive()}, flags.sigma_force);
  o.sigma_depth_A = known(Field{"sigma-depth", unit::length, "", not_negative()}, flags.sigma_depth);
  o.physics = physics_of(flags, card, o.geometry);
  o.model = flags.model;
  const ClosedForm& form = closed_form(o.model, "--model");
  if (form.pressure) throw bad_input("--model: '{}' gives a pressure, not a force", o.model);
  const Given shape = given("tip", flags.tip, curve);
  if (!shape.text.empty())
    o.sphere = parse_text(Field{.name = "tip", .choices = tip_names}, shape.text, shape.label) == "sphere";
  if (o.geometry.tip_A > 0 && form.tip != TipShape::none && (form.tip == TipShape::sphere) != o.sphere)
    throw bad_input("--model: '{}' is for a {}, the tip is a {} (--tip)", o.model, o.sphere ? "disc" : "sphere",
                    o.sphere ? "sphere" : "disc");
  if (form.tip == TipShape::sphere && o.geometry.tip_A == 0)
    throw bad_input("--tip-radius: is needed by the model '{}'", o.model);
  const Field depth_min{"depth-min", unit::length, "", any_number()},
      depth_max{"depth-max", unit::length, "", positive()};
  o.depth_min_A = known(depth_min, flags.depth_min);
  o.depth_max_A = known(depth_max, flags.depth_max);
  o.baseline_to_A = known(Field{"baseline", unit::length, "", any_number()}, flags.baseline);
  const bool contact = flags.contact == "fit" || (flags.contact.empty() && curve.zeros_unknown);
  o.free = {contact, contact || flags.fit_force_zero, flags.fit_slope};
  if (!o.free.contact) o.contact_A = known(Field{"contact", unit::length, "", any_number()}, flags.contact).value_or(0);
  o.weighting = weighting(flags.weights);
  o.bootstrap_samples = flags.bootstrap;
  o.seed = flags.seed;
  return o;
}

/// What is read of the files. A spring constant makes forces of deflections where a file has none of its own.
MeasuredRequest request_of(const FitFlags& flags) {
  MeasuredRequest request{.columns = {flags.depth_column, flags.force_column, flags.sigma_column}};
  const std::string segment = parse_text(with_words<SegmentKind>(Field{.name = "segment"}), flags.segment, "--segment");
  request.segment = from_word<SegmentKind>(segment).value();
  request.curves = flags.curves;
  if (!flags.spring_constant.empty())
    request.calibration.spring_constant_N_per_m =
        N_per_m_per_eV_per_A2 * with_unit(Field{"spring-constant", unit::membrane_force, "", positive()},
                                          {flags.spring_constant, "--spring-constant"})
                                    .value;
  request.calibration.sensitivity = si_quantity(flags.sensitivity, {"m/V", "m/A"}, "--sensitivity", "60 nm/V");
  return request;
}

/// Of several curves one that cannot be read or fitted does not stop the others; of one alone it is the command's
/// error, and so is what every one of them fails of.
class Failures {
 public:
  explicit Failures(Result& result) : result_(result) {}

  void try_on(const std::string& name, const std::function<void()>& work) {
    try {
      work();
    } catch (const Error& error) {
      if (error.exit_code() != ExitCode::bad_input) throw;
      if (!first_) first_ = std::current_exception();
      result_.unfitted.push_back({name, error.what()});
    }
  }

  void settle() const {
    if (first_ && result_.curves.empty()) std::rethrow_exception(first_);
    for (const UnfittedCurve& curve : result_.unfitted) spdlog::warn("not fitted: {}", curve.reason);
  }

 private:
  Result& result_;
  std::exception_ptr first_;
};

void fit_all(const FitFlags& flags, const std::optional<PotentialCard>& card, Result& result) {
  const MeasuredRequest request = request_of(flags);
  Failures failures(result);
  const auto fit_one = [&](const MeasuredCurve& curve) {
    FittedCurve fitted = evaluate(curve, options_of(flags, curve, card));
    fitted.notes.insert(fitted.notes.begin(), curve.notes.begin(), curve.notes.end());
    result.curves.push_back(std::move(fitted));
  };
  for (const std::string& file : flags.files)
    failures.try_on(file, [&] {
      for (const MeasuredCurve& curve : read_measured(file, request))
        failures.try_on(curve.file.string(), [&] { fit_one(curve); });
    });
  failures.settle();
}

int fit(const FitFlags& flags) {
  atomistic::use_one_math_thread();
  Result result;
  result.command = Command::fit;
  result.provenance = provenance(command_line());
  const std::optional<PotentialCard> card = card_of(flags);
  // Everything is read and checked before anything is written.
  fit_all(flags, card, result);
  if (flags.output.out) {
    OutputFolder folder(*flags.output.out, flags.output.overwrite);
    write_fit_files(result, folder.drafts());
    folder.finish(0);
  }
  if (!flags.json.empty()) write_json(result, flags.json);
  if (flags.json != "-")
    for (const FittedCurve& curve : result.curves) print_result(measured_text(curve) + "\n");
  return 0;
}

constexpr const char* fit_examples =
    R"TXT(A file is an instrument's (validate curve --help lists the formats) or a table with units in its header:
depth_nm,force_nN or "depth (nm)", "force [nN]". Lines of the form
"# radius: 0.5 um" (also nu, tip, tip-radius) stand in for flags that are not given. validate model lists the models.

Examples:
  validate fit curve.csv --radius "0.5 um" --nu 0.165 --tip-radius "16.5 nm"
  validate fit *.csv --radius "0.50 ± 0.01 um" --nu 0.165 --tip-radius "16.5 ± 2 nm" --contact fit --out fits
  validate fit runs/indentation-airebo-R110/curves.csv --run 1 --radius "110 A" --nu 0.36 --tip disc --tip-radius "10 A"
  validate fit map.jpk-force-map --radius "0.5 um" --nu 0.165 --tip-radius "16.5 nm"
  validate fit curve.csv --radius "0.5 um" --tip disc --tip-radius "16.5 nm" --potential lcbop
  validate fit curve.csv --radius "0.5 um" --nu 0.165 --tip-radius "16.5 nm" --third-order "-690 N/m" --bending 1.4
  validate fit curve.csv --radius "0.5 um" --nu 0.165 --model foeppl --tip disc --weights relative --json -)TXT";

}  // namespace

void add_fit(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("fit", "E·h and pretension of measured force-depth curves");
  const auto flags = std::make_shared<FitFlags>();
  command->add_option("files", flags->files, "measured curves, of any format of validate curve")
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
  command
      ->add_option("--run", flags->curves,
                   "of a file with several curves these alone: runs of a curves.csv, numbers of a map; default all")
      ->type_name("N,N...")
      ->delimiter(',');
  text("--segment", flags->segment, "which is fitted; approach, retract, pause; default approach", "NAME");
  text("--sensitivity-error", flags->sensitivity_error, "relative error of the deflection, 5 % say", "NUMBER");
  text("--depth-min", flags->depth_min, "smallest depth used");
  text("--depth-max", flags->depth_max, "largest depth used");
  text("--baseline", flags->baseline, "take off the mean force of the points up to this depth");
  text("--contact", flags->contact,
       "depth of the contact point, or 'fit' to find it and the zero of force with the rest; default 0");
  command->add_flag("--fit-force-zero", flags->fit_force_zero, "the zero of force is one more parameter");
  command->add_flag("--fit-slope", flags->fit_slope, "and so is a slope of the baseline");
  command
      ->add_option("--bootstrap", flags->bootstrap, "check the errors by refits to drawn noise; 0 to 100000; default 0")
      ->type_name("N")
      ->check(CLI::Range(0, 100000).description(""));
  command->add_option("--seed", flags->seed, "of the draws; default 1")->type_name("N");
  add_output_options(*command, flags->output, "folder for plots and fit.json; default: none");
  text("--json", flags->json, "write the numbers there; - is stdout", "FILE");
  command->footer(fit_examples);
  command->callback([flags, &exit_code] { exit_code = fit(*flags); });
}

}  // namespace validate
