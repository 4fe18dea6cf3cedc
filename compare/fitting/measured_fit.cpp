#include "compare/fitting/measured_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "compare/base/errors.hpp"
#include "compare/fitting/fit_warnings.hpp"

namespace validate {
namespace {

double baseline(const MeasuredCurve& curve, double to_A) {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < curve.depth_A.size(); ++i) {
    if (!(curve.depth_A[i] <= to_A)) continue;
    sum += curve.force_eV_per_A[i];
    ++count;
  }
  if (count == 0)
    throw bad_input("--baseline: {} has no point at a depth of {:g} Å or less", curve.file.string(), to_A);
  return sum / count;
}

/// Points beyond contact and inside the window, zeros taken off.
void select_points(const MeasuredCurve& curve, FittedCurve& result, const MeasuredOptions& options,
                   std::vector<double>& sigma) {
  if (options.baseline_to_A) result.baseline_eV_per_A = baseline(curve, *options.baseline_to_A);
  for (std::size_t i = 0; i < curve.depth_A.size(); ++i) {
    const double depth = curve.depth_A[i] - options.contact_A;
    if (!(depth > 0 && depth >= options.depth_min_A) || (options.depth_max_A && depth > *options.depth_max_A)) continue;
    result.depth_A.push_back(depth);
    result.force_eV_per_A.push_back(curve.force_eV_per_A[i] - result.baseline_eV_per_A);
    if (!curve.sigma_eV_per_A.empty()) sigma.push_back(curve.sigma_eV_per_A[i]);
  }
  if (result.depth_A.size() < fewest_points_to_fit)
    throw bad_input("{}: {} of {} points are beyond contact and inside the window; a fit needs {}", result.file,
                    result.depth_A.size(), curve.depth_A.size(), fewest_points_to_fit);
  if (!(std::ranges::max(result.force_eV_per_A) > 0))
    throw bad_input("{}: no force is positive; are sign and zero of the force right?", result.file);
}

/// The sheet is fitted where the closed form's offsets put the zeros.
void fit_the_sheet(FittedCurve& result, const MeasuredOptions& options, const ClosedForm& form,
                   const std::vector<double>& sigma) {
  Fit& closed = result.fits.front();
  const double shift = closed.depth_offset_A.value_or(0), lift = closed.force_offset_eV_per_A.value_or(0);
  std::vector<double> depth, force, spread;
  for (std::size_t i = 0; i < result.depth_A.size(); ++i) {
    if (!(result.depth_A[i] > shift)) continue;
    depth.push_back(result.depth_A[i] - shift);
    force.push_back(result.force_eV_per_A[i] - lift);
    if (!sigma.empty()) spread.push_back(sigma[i]);
  }
  const ModelGeometry& m = options.geometry;
  const MembraneTip tip{m.a_A, m.nu, m.tip_A, 0, options.sphere, options.physics};
  MembraneFitReport report = fit_membrane(tip, depth, force, spread);
  if (!report.converged) {
    result.direct_skipped = report.reason;
    return;
  }
  if (!report.fit.torn_at_A) {  // else what the closed form reads from it is not known over the whole window
    CurveFitOptions plain = options.fit;
    plain.bootstrap_samples = 0;
    plain.depth_offset = plain.force_offset = false;
    if (depth.size() != result.depth_A.size()) plain.sigma_eV_per_A = spread;
    const auto read = fit_curve(form.make(m), depth, report.fit.model_force_eV_per_A, plain);
    if (const auto* fit = std::get_if<Fit>(&read))
      closed.bias = fit_bias(closed, *fit, report.fit.Eh_eV_per_A2, report.fit.pretension_eV_per_A2);
  }
  for (double& d : report.fit.fitted_depth_A) d += shift;
  result.fits.push_back(std::move(report.fit));
}

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
  result.continuum = options.physics ? options.physics->name : "St Venant-Kirchhoff's membrane";
  return result;
}

}  // namespace

FittedCurve evaluate(const MeasuredCurve& curve, const MeasuredOptions& options) {
  FittedCurve result = described(curve, options);
  std::vector<double> sigma;
  select_points(curve, result, options, sigma);
  CurveFitOptions settings = options.fit;
  settings.depth_offset = options.fit_contact;
  settings.force_offset = options.fit_force_zero;
  if (settings.weighting == Weighting::sigma) {
    if (sigma.empty())
      throw bad_input("--weights sigma: {} has no column sigma; add one or choose it with --sigma-column", result.file);
    settings.sigma_eV_per_A = sigma;
  }
  const ClosedForm& form = closed_form(options.model, "--model");
  const AnyCurveModel model = form.make(options.geometry);
  auto found = fit_curve(model, result.depth_A, result.force_eV_per_A, settings);
  if (const auto* reason = std::get_if<std::string>(&found)) throw bad_input("{}: {}", result.file, *reason);
  result.fits.push_back(std::get<Fit>(std::move(found)));
  result.fits.front().model = options.model;
  result.scan = scan_window(model, result.depth_A, result.force_eV_per_A, settings);
  MeasuredOptions resolved = options;
  resolved.fit = settings;
  fit_the_sheet(result, resolved, form, settings.weighting == Weighting::sigma ? sigma : std::vector<double>{});
  FitContext context{.a_A = options.geometry.a_A};
  context.tip_assumed_a_point = options.geometry.tip_A == 0;
  if (options.geometry.bending_eV > 0) context.bending_eV = options.geometry.bending_eV;
  result.fits.front().warnings = fit_warnings(result.fits.front(), context);
  return result;
}

}  // namespace validate
