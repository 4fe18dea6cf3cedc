#include "compare/cli/fit_flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <system_error>
#include <type_traits>

#include "compare/base/errors.hpp"
#include "compare/base/field_value.hpp"
#include "compare/base/toml_file.hpp"
#include "compare/instruments/si_quantity.hpp"

namespace validate {
namespace {

constexpr std::array<std::string_view, 2> tip_names = {"sphere", "disc"};
constexpr std::array<std::string_view, 4> weight_names = {"automatic", "uniform", "relative", "sigma"};

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
  if (name.empty()) return Weighting::automatic;
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

/// "0,2,5"
std::vector<int> curve_numbers(const std::string& list) {
  std::vector<int> numbers;
  for (std::size_t from = 0; from < list.size();) {
    const std::size_t to = std::min(list.find(',', from), list.size());
    int number = -1;
    const auto [end, error] = std::from_chars(list.data() + from, list.data() + to, number);
    if (error != std::errc() || end != list.data() + to || number < 0)
      throw bad_input("--run: '{}' is no list of curves; write their numbers like 0,2,5", list);
    numbers.push_back(number);
    from = to + 1;
  }
  return numbers;
}

}  // namespace

void take_settings(FitFlags& flags) {
  if (flags.settings.empty()) return;
  FitFlags said;
  TomlFile(flags.settings, "--settings").read(said);
  std::vector<std::string*> texts;
  std::vector<bool*> switches;
  const auto collect = [&](const Field&, auto& value) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, bool>)
      switches.push_back(&value);
    else
      texts.push_back(&value);
  };
  describe(said, collect);
  describe(flags, collect);
  for (std::size_t i = 0, n = texts.size() / 2; i < n; ++i)
    if (texts[n + i]->empty()) *texts[n + i] = *texts[i];
  for (std::size_t i = 0, n = switches.size() / 2; i < n; ++i) *switches[n + i] = *switches[n + i] || *switches[i];
}

MeasuredRequest request_of(const FitFlags& flags) {
  MeasuredRequest request{.columns = {flags.depth_column, flags.force_column, flags.sigma_column}};
  if (!flags.segment.empty())
    request.segment = from_word<SegmentKind>(
                          parse_text(with_words<SegmentKind>(Field{.name = "segment"}), flags.segment, "--segment"))
                          .value();
  request.curves = curve_numbers(flags.curves);
  request.baseline = from_word<Baseline>(flags.baseline);
  if (!flags.spring_constant.empty())
    request.calibration.spring_constant_N_per_m =
        N_per_m_per_eV_per_A2 * with_unit(Field{"spring-constant", unit::membrane_force, "", positive()},
                                          {flags.spring_constant, "--spring-constant"})
                                    .value;
  request.calibration.sensitivity = si_quantity(flags.sensitivity, {"m/V", "m/A"}, "--sensitivity", "60 nm/V");
  return request;
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
    o.spring_constant_eV_per_A2 = curve.spring_constant_eV_per_A2.value_or(k.value);
    o.errors.force_scale_relative = k.error / k.value;
  } else {
    o.spring_constant_eV_per_A2 = curve.spring_constant_eV_per_A2;
  }
  if (!flags.sensitivity_error.empty())
    o.errors.sensitivity_relative = share(flags.sensitivity_error, "--sensitivity-error");
  o.sigma_force_eV_per_A = known(Field{"sigma-force", unit::force, "", positive()}, flags.sigma_force);
  o.sigma_depth_A = known(Field{"sigma-depth", unit::length, "", not_negative()}, flags.sigma_depth);
  o.physics = physics_of(flags, card, o.geometry);
  if (!flags.model.empty()) o.model = flags.model;
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
  if (!from_word<Baseline>(flags.baseline))
    o.baseline_to_A = known(Field{"baseline", unit::length, "", any_number()}, flags.baseline);
  const bool contact = flags.contact == "fit" || (flags.contact.empty() && curve.preparation);
  const bool tilted = curve.preparation && curve.preparation->baseline == Baseline::tilt;
  o.free = {contact, contact || flags.fit_force_zero, flags.fit_slope || tilted};
  if (!o.free.contact) o.contact_A = known(Field{"contact", unit::length, "", any_number()}, flags.contact).value_or(0);
  o.weighting = weighting(flags.weights);
  o.bootstrap_samples = flags.bootstrap;
  o.seed = flags.seed;
  return o;
}

}  // namespace validate
