#include "compare/fitting/measured_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <variant>

#include "compare/base/errors.hpp"
#include "compare/base/units.hpp"
#include "compare/fitting/fit_warnings.hpp"
#include "compare/fitting/inference.hpp"
#include "compare/fitting/measured_points.hpp"
#include "compare/fitting/sheet_table.hpp"

namespace validate {
namespace {

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
  InferenceOptions inference{options.free, instrument_inputs(model, options), options.bootstrap_samples, options.seed};
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

/// The continuum itself, tabulated about what a first fit says and again where its interval reaches further.
class ContinuumFit {
 public:
  ContinuumFit(const CurvePoints& points, const MeasuredOptions& options, const std::optional<SheetPhysics>& physics)
      : points_(points), options_(options), physics_(physics) {}

  std::variant<Fit, std::string> run(const Fit& first) {
    constexpr int most_tables = 4;
    range_.Eh_eV_per_A2 = first.Eh_eV_per_A2;
    range_.pretension_share = share_of(first);
    range_.deepest_A = std::ranges::max(points_.depth_A) - first.contact_nm.value_or(0) * 10 + depth_margin(first);
    for (int attempt = 1;; ++attempt) {
      auto found = with_table();
      const Fit* fit = std::get_if<Fit>(&found);
      if (!fit || attempt == most_tables || covered(*fit)) return found;
      range_.Eh_eV_per_A2 = fit->Eh_eV_per_A2;
      range_.pretension_share = std::max(share_of(*fit), range_.pretension_share);
      range_.deepest_A =
          std::max(range_.deepest_A, std::ranges::max(points_.depth_A) - fit->contact_nm.value_or(0) * 10);
    }
  }

 private:
  /// The larger end of what the pretension may be.
  static double share_of(const Fit& fit) {
    const double most = std::isfinite(fit.pretension_interval_eV_per_A2[1]) ? fit.pretension_interval_eV_per_A2[1]
                                                                            : 3 * std::abs(fit.pretension_eV_per_A2);
    return 1.3 * std::max(most, 0.0) / fit.Eh_eV_per_A2;
  }
  double depth_margin(const Fit& first) const {
    return options_.free.contact ? 30 * std::max(first.contact_stderr_nm.value_or(0), 0.1) : 0;
  }
  bool covered(const Fit& fit) const {
    const double most = std::isfinite(fit.pretension_interval_eV_per_A2[1]) ? fit.pretension_interval_eV_per_A2[1]
                                                                            : fit.pretension_eV_per_A2;
    return most / fit.Eh_eV_per_A2 <= range_.pretension_share * 1.05 &&
           (!physics_ || std::abs(std::log(fit.Eh_eV_per_A2 / range_.Eh_eV_per_A2)) < 0.1) &&
           std::ranges::max(points_.depth_A) - fit.contact_nm.value_or(0) * 10 <= range_.deepest_A * 1.001;
  }

  std::variant<Fit, std::string> with_table() {
    const MembraneTip tip = tip_of(options_.geometry, options_.sphere, physics_);
    const ForceModel table = sheet_table(tip, range_);
    InferenceOptions inference{options_.free, instrument_inputs(table, options_), options_.bootstrap_samples,
                               options_.seed};
    for (const auto& [name, member] : geometry_inputs) {
      if (!(options_.errors.geometry.*member > 0)) continue;
      MembraneTip other = tip;
      ModelGeometry geometry = options_.geometry;
      geometry.*member += options_.errors.geometry.*member;
      other.a_A = geometry.a_A;
      other.nu = geometry.nu;
      other.tip_A = geometry.tip_A;
      if (other.physics) other.physics->bending_eV = geometry.bending_eV;
      if (std::string_view(name) == "nu" && physics_) continue;  // the law has its own
      if (std::string_view(name) == "bending" && !physics_) continue;
      inference.inputs.push_back({name, with_tip(table, tip, other, range_)});
    }
    CurvePoints kept = points_;
    const double end = table.deepest_A * (1 + 1e-9);
    const bool torn = end < range_.deepest_A * (1 - 1e-6);
    if (torn) keep_up_to(kept, end);
    auto found = infer(kept, table, inference);
    if (Fit* fit = std::get_if<Fit>(&found)) {
      fit->model = physics_ ? physics_->model : fitted_membrane;
      if (torn) fit->torn_at_A = table.deepest_A;
    }
    return found;
  }

  /// Deeper points are left out: the law does not go there, whatever the contact.
  static void keep_up_to(CurvePoints& points, double deepest) {
    CurvePoints kept;
    kept.noise = points.noise;
    kept.noise.force_weight.clear();
    for (std::size_t i = 0; i < points.depth_A.size(); ++i) {
      if (points.depth_A[i] > deepest) continue;
      kept.depth_A.push_back(points.depth_A[i]);
      kept.force_eV_per_A.push_back(points.force_eV_per_A[i]);
      if (!points.noise.force_weight.empty()) kept.noise.force_weight.push_back(points.noise.force_weight[i]);
    }
    points = std::move(kept);
  }

  const CurvePoints& points_;
  const MeasuredOptions& options_;
  std::optional<SheetPhysics> physics_;
  TableRange range_;
};

/// Adds a continuum's fit, or why there is none.
void add_continuum(FittedCurve& result, const CurvePoints& points, const MeasuredOptions& options,
                   const std::optional<SheetPhysics>& physics, const Fit& first) {
  const char* name = physics ? physics->model.c_str() : fitted_membrane;
  std::string reason;
  try {
    auto found = ContinuumFit(points, options, physics).run(first);
    if (Fit* fit = std::get_if<Fit>(&found)) {
      result.fits.push_back(std::move(*fit));
      return;
    }
    reason = std::get<std::string>(found);
  } catch (const std::exception& problem) {
    reason = problem.what();
  }
  result.skipped += fmt::format("{}{}: {}", result.skipped.empty() ? "" : "; ", name, reason);
}

/// This fit against the depth up to which the points go: some twenty windows.
WindowScan scan_of(const CurvePoints& points, const MeasuredOptions& options) {
  constexpr std::size_t windows = 20;
  std::vector<std::size_t> order(points.depth_A.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return points.depth_A[i]; });
  const ForceModel model = force_model(closed_form(options.model, "--model").make(options.geometry));
  WindowScan scan;
  CurvePoints part;
  part.noise = points.noise;
  part.noise.force_weight.clear();
  const std::size_t every = std::max<std::size_t>(1, order.size() / windows);
  for (std::size_t k = 0; k < order.size(); ++k) {
    part.depth_A.push_back(points.depth_A[order[k]]);
    part.force_eV_per_A.push_back(points.force_eV_per_A[order[k]]);
    if (!points.noise.force_weight.empty()) part.noise.force_weight.push_back(points.noise.force_weight[order[k]]);
    const bool last = k + 1 == order.size();
    if ((!last && (order.size() - 1 - k) % every != 0) || part.depth_A.back() <= 0 ||
        part.depth_A.size() < fewest_points_to_fit)
      continue;
    Likelihood likelihood(part, model, options.free);
    if (part.depth_A.size() <= static_cast<std::size_t>(likelihood.parameter_count())) continue;
    const LikelihoodMaximum best = most_likely(likelihood);
    if (!best.converged) continue;
    scan.depth_max_A.push_back(part.depth_A.back());
    scan.Eh_eV_per_A2.push_back(best.theta[0]);
    scan.pretension_eV_per_A2.push_back(best.theta[1]);
  }
  return scan;
}

/// What the recommended sheet, whose constants the fit says, is read as by the closed form at the same depths.
void add_bias(FittedCurve& result, const CurvePoints& points, const MeasuredOptions& options) {
  const Fit* known = recommended_fit(result.fits);
  Fit* closed = closed_form_fit(result.fits);
  if (!known || !closed || known->torn_at_A || known->fitted_depth_A.size() != points.depth_A.size()) return;
  CurvePoints exact = points;
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
  auto closed = fit_closed_form(points, options, options.model);
  if (const auto* reason = std::get_if<std::string>(&closed)) throw bad_input("{}: {}", result.file, *reason);
  result.fits.push_back(std::get<Fit>(std::move(closed)));
  result.fits.front().model = options.model;
  result.fits.front().scan = scan_of(points, options);
  // Where to tabulate: what the shallow sheet of the same tip says.
  const ModelGeometry& m = options.geometry;
  const char* shallow = m.tip_A > 0 && options.sphere ? "sphere-pretension" : "foeppl";
  MeasuredOptions quick = options;
  quick.errors = {};
  quick.bootstrap_samples = 0;
  const auto first = fit_closed_form(points, quick, shallow);
  const Fit start = std::holds_alternative<Fit>(first) ? std::get<Fit>(first) : result.fits.front();
  add_continuum(result, points, options, std::nullopt, start);
  if (options.physics) {
    const Fit plain = result.fits.back();
    add_continuum(result, points, options, options.physics, plain);
  }
  recommend(result);
  add_bias(result, points, options);
  add_notes(result, options);
  add_warnings(result, options.geometry);
  return result;
}

}  // namespace validate
