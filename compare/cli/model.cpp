#include "compare/cli/model.hpp"

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "compare/base/errors.hpp"
#include "compare/base/field_value.hpp"
#include "compare/base/standard_streams.hpp"
#include "compare/base/terminal.hpp"
#include "compare/base/units.hpp"
#include "compare/fitting/models/list.hpp"

namespace validate {
namespace {

struct ModelFlags {
  std::string radius, nu, tip_radius = "0", bending = "0", Eh, pretension = "0";
  std::string depths;
};

std::string description(const ClosedForm& form) {
  return fmt::format("{}\n  {}\n  holds for: {}\n  source: {}\n", form.name, form.formula, form.validity, form.source);
}

double number(const char* name, std::string_view base, Range range, const std::string& text) {
  if (text.empty()) throw bad_input("--{}: is needed to evaluate the model at --depths", name);
  return parse_number(Field{name, base, "", range}, text, fmt::format("--{}", name));
}

std::vector<double> depths_of(const std::string& text) {
  std::vector<double> depths;
  for (std::size_t from = 0; from <= text.size();) {
    const auto to = std::min(text.find(',', from), text.size());
    depths.push_back(number("depths", unit::length, positive(), text.substr(from, to - from)));
    from = to + 1;
  }
  return depths;
}

void evaluate(const ClosedForm& form, const ModelFlags& flags) {
  const ModelGeometry geometry{number("radius", unit::length, positive(), flags.radius),
                               number("nu", unit::none, between(-1, 1), flags.nu),
                               number("tip-radius", unit::length, not_negative(), flags.tip_radius),
                               number("bending", unit::none, not_negative(), flags.bending)};
  if (form.tip == TipShape::sphere && geometry.tip_A == 0)
    throw bad_input("--tip-radius: is needed by '{}'", form.name);
  if (form.name == "tip-pretension" && geometry.tip_A == 0)
    throw bad_input("--tip-radius: is needed by '{}'", form.name);
  const double parameters[] = {number("Eh", unit::membrane_force, positive(), flags.Eh),
                               number("pretension", unit::membrane_force, not_negative(), flags.pretension)};
  const AnyCurveModel model = form.make(geometry);
  print_result(form.pressure ? "depth_nm,pressure_MPa\n" : "depth_nm,force_nN\n");
  for (const double depth : depths_of(flags.depths)) {
    const double value = model.value(depth, parameters);
    print_result(fmt::format("{:.6g},{:.6g}\n", depth / 10,
                             form.pressure ? 1e3 * GPa_per_eV_per_A3 * value : nN_per_eV_per_A * value));
  }
}

}  // namespace

void add_model(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("model", "closed-form models: formula, validity, source, values");
  command->footer(
      "Examples:\n  validate model\n  validate model foeppl --help\n"
      "  validate model foeppl --radius \"0.5 um\" --nu 0.165 --tip-radius \"16.5 nm\" --Eh \"342 N/m\" "
      "--pretension \"0.34 N/m\" --depths \"20 nm,50 nm,100 nm\"");
  for (const ClosedForm& form : closed_forms()) {
    CLI::App* one = command->add_subcommand(std::string(form.name), std::string(form.formula));
    const auto flags = std::make_shared<ModelFlags>();
    const auto text = [&](const char* name, std::string& value, const char* meaning) {
      one->add_option(name, value, meaning)->type_name("VALUE");
    };
    text("--radius", flags->radius, "clamp radius; > 0 Å");
    text("--nu", flags->nu, "Poisson's ratio");
    text("--tip-radius", flags->tip_radius, "radius of the loaded disc or sphere; default 0, a point");
    text("--bending", flags->bending, "bending modulus in eV; default 0");
    text("--Eh", flags->Eh, "sheet modulus; > 0 eV/Å²");
    text("--pretension", flags->pretension, "membrane force of the flat sheet; default 0");
    text("--depths", flags->depths, "depths separated by commas; prints a table");
    one->footer(description(form));
    one->callback([&form, flags, &exit_code] {
      if (flags->depths.empty()) print_text(description(form));
      if (!flags->depths.empty()) evaluate(form, *flags);
      exit_code = 0;
    });
  }
  command->callback([command, &exit_code] {
    if (!command->get_subcommands().empty()) return;
    for (const ClosedForm& form : closed_forms()) print_text(description(form) + "\n");
    exit_code = 0;
  });
}

}  // namespace validate
