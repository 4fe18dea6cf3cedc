#include "compare/fitting/measured_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>
#include <utility>
#include <variant>

#include "compare/base/errors.hpp"
#include "compare/base/units.hpp"
#include "compare/fitting/fit_warnings.hpp"
#include "compare/fitting/inference.hpp"
#include "compare/fitting/measured_points.hpp"
#include "compare/fitting/measured_scan.hpp"
#include "compare/fitting/sheet_table.hpp"

namespace validate {
namespace {

constexpr double A_per_nm = 10;

FittedCurve described(const MeasuredCurve& curve, const MeasuredOptions& options) {
  FittedCurve result;
  result.file = curve.file.string();
  result.model = options.model;
  result.radius_A = options.geometry.a_A;
  result.nu = options.geometry.nu;
  result.tip = options.geometry.tip_A == 0 ? TipKind::point : options.sphere ? TipKind::sphere : TipKind::disc;
  result.tip_radius_A = options.geometry.tip_A;
  result.bending_modulus_eV = options.geometry.bending_eV;
  result.depth_column = curve.depth_column;
  result.force_column = curve.force_column;
  result.points_read = static_cast<int>(curve.depth_A.size());
  result.preparation = curve.preparation;
  if (options.physics) result.continuum = options.physics->name;
  return result;
}

/// A member of the geometry with its standard error.
struct GeometryInput {
  const char* name;
  double ModelGeometry::*value;
};
constexpr GeometryInput geometry_inputs[] = {{"radius", &ModelGeometry::a_A},
                                             {"nu", &ModelGeometry::nu},
                                             {"tip-radius", &ModelGeometry::tip_A},
                                             {"bending", &ModelGeometry::bending_eV}};

/// Inputs that act on the measured forces and depths: seen from the model, the other way round.
std::vector<UncertainInput> instrument_inputs(const ForceModel& model, const MeasuredOptions& options) {
  std::vector<UncertainInput> inputs;
  if (const double e = options.errors.force_scale_relative; e > 0)
    inputs.push_back({"spring constant", scaled(model, 1 + e)});
  if (const double e = options.errors.sensitivity_relative; e > 0) {
    // Deflection read too large by e: forces too large by e, depths too small by e F / k.
    const double compliance = options.spring_constant_eV_per_A2 ? 1 / *options.spring_constant_eV_per_A2 : 0;
    inputs.push_back({"sensitivity", with_forces(model, [at = model.at, e, compliance](double d, double Eh, double N0) {
                        const ForceAt here = at(d, Eh, N0), deeper = at(d + e * compliance * here.force, Eh, N0);
                        return ForceAt{(1 + e) * deeper.force, (1 + e) * deeper.by_Eh, (1 + e) * deeper.by_pretension};
                      })});
  }
  return inputs;
}

std::variant<Fit, std::string> fit_closed_form(const CurvePoints& points, const MeasuredOptions& options,
                                               const std::string& name) {
  const ClosedForm& form = closed_form(name, "--model");
  const ForceModel model = force_model(form.make(options.geometry));
  InferenceOptions inference{options.free, instrument_inputs(model, options), !options.quoted_alone,
                             options.bootstrap_samples, options.seed};
  for (const auto& [input, member] : geometry_inputs) {
    if (!(options.errors.geometry.*member > 0)) continue;
    ModelGeometry other = options.geometry;
    other.*member += options.errors.geometry.*member;
    inference.inputs.push_back({input, force_model(form.make(other))});
  }
  return infer(points, model, inference);
}

MembraneTip tip_of(const ModelGeometry& m, bool sphere, const std::optional<SheetPhysics>& physics) {
  MembraneTip tip{m.a_A, m.nu, m.tip_A, 0, sphere, physics};
  return tip;
}

}  // namespace

SheetModel sheet_model(const MeasuredOptions& options, const std::optional<SheetPhysics>& physics,
                       const TableRange& range) {
  const MembraneTip tip = tip_of(options.geometry, options.sphere, physics);
  SheetModel sheet{sheet_table(tip, range), {}};
  sheet.inputs = instrument_inputs(sheet.model, options);
  for (const auto& [name, member] : geometry_inputs) {
    if (!(options.errors.geometry.*member > 0)) continue;
    MembraneTip other = tip;
    ModelGeometry geometry = options.geometry;
    geometry.*member += options.errors.geometry.*member;
    other.a_A = geometry.a_A;
    other.nu = geometry.nu;
    other.tip_A = geometry.tip_A;
    if (other.physics) other.physics->bending_eV = geometry.bending_eV;
    if (std::string_view(name) == "nu" && physics) continue;  // the law has its own
    if (std::string_view(name) == "bending" && !physics) continue;
    sheet.inputs.push_back({name, with_tip(sheet.model, tip, other, range)});
  }
  return sheet;
}

namespace {

/// Where a continuum is tabulated about.
struct Guess {
  double Eh = 1, most_pretension = 0;  ///< eV/Å²; its larger end
  double contact_A = 0, contact_error_A = 0;

  explicit Guess(const Fit& fit)
      : Eh(fit.Eh_eV_per_A2),
        most_pretension(std::isfinite(fit.pretension_interval_eV_per_A2[1]) ? fit.pretension_interval_eV_per_A2[1]
                                                                            : 3 * std::abs(fit.pretension_eV_per_A2)),
        contact_A(A_per_nm * fit.contact_nm.value_or(0)),
        contact_error_A(A_per_nm * fit.contact_stderr_nm.value_or(0)) {}

  Guess(const Likelihood& likelihood, const LikelihoodMaximum& best)
      : Eh(best.theta[0]), most_pretension(best.theta[1] + 2 * std::sqrt(best.covariance(1, 1))) {
    if (const int i = likelihood.contact_index(); i >= 0) {
      contact_A = likelihood.contact_depth(best.theta);
      contact_error_A = std::sqrt(best.covariance(i, i));
    }
  }
};

/// What the shallow sheet under the same tip says, if it does.
std::optional<Guess> shallow_guess(const CurvePoints& points, const MeasuredOptions& options) {
  const ModelGeometry& m = options.geometry;
  const char* shallow = m.tip_A > 0 && options.sphere ? "sphere-pretension" : "foeppl";
  Likelihood likelihood(points, force_model(closed_form(shallow, "--model").make(m)), options.free);
  if (points.depth_A.size() <= static_cast<std::size_t>(likelihood.parameter_count())) return std::nullopt;
  constexpr double roughly = 1e-2;  // of many curves: a table reaches further than what is left
  const LikelihoodMaximum best =
      options.quoted_alone ? maximise(likelihood, likelihood.start(), {}, roughly) : most_likely(likelihood);
  return best.converged ? std::optional(Guess(likelihood, best)) : std::nullopt;
}

/// The continuum itself, tabulated about what a first fit says and again where its interval reaches further.
class ContinuumFit {
 public:
  ContinuumFit(const CurvePoints& points, const MeasuredOptions& options, const std::optional<SheetPhysics>& physics)
      : points_(points), options_(options), physics_(physics) {}

  std::variant<Fit, std::string> run(const Guess& first) {
    constexpr int most_tables = 4;
    const double least_margin = 1;  // Å
    range_ = {deepest_of(first), first.Eh, share_of(first)};
    if (options_.free.contact) range_.deepest_A += 3 * std::max(first.contact_error_A, least_margin);
    for (int attempt = 1;; ++attempt) {
      auto found = with_table();
      const Fit* fit = std::get_if<Fit>(&found);
      if (!fit || attempt == most_tables || covers(Guess(*fit))) return found;
      const Guess next(*fit);
      range_ = {std::max(range_.deepest_A, deepest_of(next)), next.Eh,
                std::max(share_of(next), range_.pretension_share)};
    }
  }

 private:
  double deepest_of(const Guess& guess) const { return std::ranges::max(points_.depth_A) - guess.contact_A; }
  static double share_of(const Guess& guess) { return 1.3 * std::max(guess.most_pretension, 0.0) / guess.Eh; }
  bool covers(const Guess& guess) const {
    return guess.most_pretension / guess.Eh <= range_.pretension_share * 1.05 &&
           (!physics_ || std::abs(std::log(guess.Eh / range_.Eh_eV_per_A2)) < 0.1) &&
           deepest_of(guess) <= range_.deepest_A * 1.001;
  }

  std::variant<Fit, std::string> with_table() {
    const auto [table, inputs] = sheet_model(options_, physics_, range_);
    const InferenceOptions inference{options_.free, inputs, !options_.quoted_alone, options_.bootstrap_samples,
                                     options_.seed};
    const bool torn = table.deepest_A < range_.deepest_A * (1 - 1e-6);
    auto found = infer(torn ? up_to(points_, table.deepest_A) : points_, table, inference);
    if (Fit* fit = std::get_if<Fit>(&found)) {
      fit->model = physics_ ? physics_->model : fitted_membrane;
      if (torn) fit->torn_at_A = table.deepest_A;
    }
    return found;
  }

  /// Deeper points are left out: the law does not go there, whatever the contact.
  static CurvePoints up_to(const CurvePoints& points, double deepest) {
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < points.depth_A.size(); ++i)
      if (points.depth_A[i] <= deepest * (1 + 1e-9)) kept.push_back(i);
    return selected(points, kept);
  }

  const CurvePoints& points_;
  const MeasuredOptions& options_;
  std::optional<SheetPhysics> physics_;
  TableRange range_;
};

/// Adds a continuum's fit, or why there is none.
void add_continuum(FittedCurve& result, const CurvePoints& points, const MeasuredOptions& options,
                   const std::optional<SheetPhysics>& physics, const Guess& first) {
  const char* name = physics ? physics->model.c_str() : fitted_membrane;
  std::string reason;
  try {
    auto found = ContinuumFit(points, options, physics).run(first);
    if (Fit* fit = std::get_if<Fit>(&found)) {
      result.fits.push_back(std::move(*fit));
      return;
    }
    reason = std::get<std::string>(found);
  } catch (const std::bad_alloc&) {  // another time it would be
    throw;
  } catch (const std::exception& problem) {
    reason = problem.what();
  }
  result.skipped += fmt::format("{}{}: {}", result.skipped.empty() ? "" : "; ", name, reason);
}

void add_closed_form(FittedCurve& result, const CurvePoints& points, const MeasuredOptions& options) {
  auto closed = fit_closed_form(points, options, options.model);
  if (const auto* reason = std::get_if<std::string>(&closed)) throw bad_input("{}: {}", result.file, *reason);
  result.fits.push_back(std::get<Fit>(std::move(closed)));
  result.fits.back().model = options.model;
  if (!options.quoted_alone) result.fits.back().scan = scan_of(points, options);
}

/// What the recommended sheet, whose constants the fit says, is read as by the closed form at the same depths.
void add_bias(FittedCurve& result, const CurvePoints& points, const MeasuredOptions& options) {
  const Fit* known = recommended_fit(result.fits);
  Fit* closed = closed_form_fit(result.fits);
  if (!known || !closed || known->torn_at_A || known->fitted_depth_A.size() != points.depth_A.size()) return;
  CurvePoints exact = points;
  exact.depth_A = known->fitted_depth_A;
  exact.force_eV_per_A = known->model_force_eV_per_A;
  const ForceModel model = force_model(closed_form(options.model, "--model").make(options.geometry));
  Likelihood likelihood(std::move(exact), model, options.free);
  const LikelihoodMaximum read = most_likely(likelihood);
  if (read.converged)
    closed->bias = FitBias{known->Eh_eV_per_A2, read.theta[0], known->pretension_eV_per_A2, read.theta[1]};
}

/// The fit to quote: a sheet of another law where it was asked for, goes to the deepest point and is no less likely
/// than the membrane; else the membrane; else the closed form.
void recommend(FittedCurve& result) {
  Fit *plain = nullptr, *other = nullptr;
  for (Fit& fit : result.fits) {
    if (fit.model == fitted_membrane) plain = &fit;
    if (of_continuum(fit) && fit.model != fitted_membrane) other = &fit;
  }
  constexpr double decisive = 10;  // of −2 ln L: 150 to 1
  const bool as_likely = other && plain && other->points == plain->points &&
                         other->minus_two_log_likelihood < plain->minus_two_log_likelihood + decisive;
  Fit* best = other && (!plain || as_likely) ? other : plain ? plain : &result.fits.front();
  best->recommended = true;
}

void add_notes(FittedCurve& result, const MeasuredOptions& options) {
  const auto note = [&](std::string text) { result.notes.push_back(std::move(text)); };
  if (!(options.errors.geometry.a_A > 0))
    note(
        "the radius is taken as exact: 1 % of it is 2 % of E·h, which no curve can tell apart (--radius \"0.50 ± 0.01 "
        "um\")");
  if (!(options.errors.force_scale_relative > 0))
    note(
        "the forces' scale is taken as exact: 1 % of the spring constant is 1 % of E·h and of the pretension "
        "(--spring-constant \"2.0 ± 0.1 N/m\")");
}

}  // namespace

FittedCurve evaluate(const MeasuredCurve& curve, const MeasuredOptions& options) {
  FittedCurve result = described(curve, options);
  const CurvePoints points = measured_points(curve, options, result.baseline_eV_per_A);
  result.depth_A = points.depth_A;
  result.force_eV_per_A = points.force_eV_per_A;
  std::optional<Guess> start = shallow_guess(points, options);
  if (!options.quoted_alone || !start) {
    add_closed_form(result, points, options);
    if (!start) start = Guess(result.fits.front());
  }
  add_continuum(result, points, options, std::nullopt, *start);
  if (result.fits.empty()) add_closed_form(result, points, options);
  if (options.physics) add_continuum(result, points, options, options.physics, Guess(result.fits.back()));
  recommend(result);
  add_bias(result, points, options);
  add_notes(result, options);
  add_warnings(result, options.geometry);
  return result;
}

}  // namespace validate
