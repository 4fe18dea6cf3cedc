#include "compare/fitting/run_fit.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "compare/fitting/curve.hpp"
#include "compare/fitting/fit.hpp"
#include "compare/fitting/fit_intervals.hpp"
#include "compare/fitting/membrane_fit.hpp"
#include "compare/fitting/models/eq16.hpp"

namespace validate {
namespace {

std::vector<double> weights_of(const std::vector<double>& force, const CurveFitOptions& options) {
  std::vector<double> weights;
  if (options.weighting == Weighting::uniform) return weights;
  const std::vector<double>& spread = options.weighting == Weighting::sigma ? options.sigma_eV_per_A : force;
  // A force that happens to be near zero must not outweigh all others.
  const double floor = options.weighting == Weighting::relative ? 0.01 * std::ranges::max(force) : 0;
  for (const double s : spread) weights.push_back(1 / std::pow(std::max(std::abs(s), floor), 2));
  return weights;
}

/// Parameters of the right size: E·h from the deepest point, no pretension, no offset.
std::vector<double> start_of(const AnyCurveModel& model, const std::vector<double>& depth,
                             const std::vector<double>& force) {
  std::vector<double> start(static_cast<std::size_t>(model.parameter_count), 0);
  start[0] = 1;
  const auto deepest = static_cast<std::size_t>(std::ranges::max_element(depth) - depth.begin());
  start[0] = force[deepest] / model.value(depth[deepest], start);
  return start;
}

LeastSquaresReport least_squares_of(const AnyCurveModel& model, const std::vector<double>& depth,
                                    const std::vector<double>& force, const LeastSquaresOptions& options) {
  return least_squares(model, depth, force, start_of(model, depth, force), options);
}

Fit fit_of(const LeastSquaresReport& report, const std::vector<double>& depth, const std::vector<double>& force) {
  Fit fit;
  fit.Eh_eV_per_A2 = report.parameters[0];
  fit.Eh_stderr_eV_per_A2 = report.standard_errors[0];
  fit.pretension_eV_per_A2 = report.parameters[1];
  fit.pretension_stderr_eV_per_A2 = report.standard_errors[1];
  fit.correlation = report.correlation(0, 1);
  for (Eigen::Index i = 0; i < report.correlation.rows(); ++i)
    for (Eigen::Index j = 0; j < report.correlation.cols(); ++j)
      fit.correlation_matrix.push_back(report.correlation(i, j));
  fit.rms_relative = rms(report.residuals) / std::ranges::max(force);
  fit.window_A = {std::ranges::min(depth), std::ranges::max(depth)};
  fit.points = static_cast<int>(depth.size());
  fit.r_squared = report.r_squared;
  fit.condition_number = report.condition_number;
  fit.fitted_depth_A = depth;
  fit.residual_eV_per_A = report.residuals;
  return fit;
}

void read_offsets(Fit& fit, const LeastSquaresReport& report, const CurveFitOptions& options) {
  if (options.depth_offset) {
    fit.depth_offset_A = report.parameters[2];
    fit.depth_offset_stderr_A = report.standard_errors[2];
  }
  if (options.force_offset) {
    fit.force_offset_eV_per_A = report.parameters.back();
    fit.force_offset_stderr_eV_per_A = report.standard_errors.back();
  }
}

}  // namespace

std::variant<Fit, std::string> fit_curve(const AnyCurveModel& bare, const std::vector<double>& depth,
                                         const std::vector<double>& force, const CurveFitOptions& options) {
  const AnyCurveModel model = with_offsets(bare, options.depth_offset, options.force_offset);
  const LeastSquaresOptions settings{.weights = weights_of(force, options), .geodesic_acceleration = true};
  const LeastSquaresReport report = least_squares_of(model, depth, force, settings);
  if (!report.converged) return report.reason;
  Fit fit = fit_of(report, depth, force);
  read_offsets(fit, report, options);
  const auto intervals = profile_intervals(model, depth, force, report, settings);
  fit.Eh_interval_eV_per_A2 = intervals[0];
  fit.pretension_interval_eV_per_A2 = intervals[1];
  const Bootstrap drawn = bootstrap(model, depth, report, settings, options.bootstrap_samples, options.seed);
  if (drawn.samples > 0) {
    fit.Eh_bootstrap_eV_per_A2 = drawn.standard_errors[0];
    fit.pretension_bootstrap_eV_per_A2 = drawn.standard_errors[1];
  }
  return fit;
}

WindowScan scan_window(const AnyCurveModel& bare, const std::vector<double>& depth, const std::vector<double>& force,
                       const CurveFitOptions& options) {
  const AnyCurveModel model = with_offsets(bare, options.depth_offset, options.force_offset);
  std::vector<std::size_t> order(depth.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return depth[i]; });
  WindowScan scan;
  std::vector<double> d, f;
  CurveFitOptions part = options;
  part.sigma_eV_per_A.clear();
  for (const std::size_t i : order) {
    d.push_back(depth[i]);
    f.push_back(force[i]);
    if (options.weighting == Weighting::sigma) part.sigma_eV_per_A.push_back(options.sigma_eV_per_A[i]);
    if (d.size() < std::max<std::size_t>(fewest_points_to_fit, static_cast<std::size_t>(model.parameter_count) + 1))
      continue;
    const auto report = least_squares_of(model, d, f, {.weights = weights_of(f, part)});
    if (!report.converged) continue;
    scan.depth_max_A.push_back(depth[i]);
    scan.Eh_eV_per_A2.push_back(report.parameters[0]);
    scan.pretension_eV_per_A2.push_back(report.parameters[1]);
  }
  return scan;
}

FitBias fit_bias(const Fit& fit, const Fit& membranes, double Eh_true, double pretension_true) {
  FitBias bias{.Eh_true_eV_per_A2 = Eh_true,
               .Eh_read_eV_per_A2 = membranes.Eh_eV_per_A2,
               .pretension_true_eV_per_A2 = pretension_true,
               .pretension_read_eV_per_A2 = membranes.pretension_eV_per_A2};
  bias.Eh_corrected_eV_per_A2 = fit.Eh_eV_per_A2 * Eh_true / membranes.Eh_eV_per_A2;
  bias.pretension_corrected_eV_per_A2 = fit.pretension_eV_per_A2 + pretension_true - membranes.pretension_eV_per_A2;
  return bias;
}

namespace {

std::string too_few(const Run& run, std::size_t usable) {
  std::size_t artefacts = 0, unconverged = 0;
  if (run.is_atomistic()) artefacts = static_cast<std::size_t>(std::ranges::count(run.atoms().artefact, true));
  for (const bool flag : run.converged) unconverged += !flag;
  return fmt::format("{} usable points of {} ({} in the artefact zone, {} not converged); a fit needs {}", usable,
                     run.depth_A.size(), artefacts, unconverged, fewest_points_to_fit);
}

struct UsablePoints {
  std::vector<double> depth, force;
};

UsablePoints usable(const Run& run) {
  UsablePoints points;
  for (const std::size_t i : usable_points(run)) {
    points.depth.push_back(run.depth_A[i]);
    points.force.push_back(run.force_eV_per_A[i]);
  }
  return points;
}

}  // namespace

void fit_run(Run& run) {
  run.fits.clear();
  run.fit_skipped.clear();
  run.scan = {};
  if (run.load == LoadKind::pressure) {
    run.fit_skipped = "Eq. 16 is for an indenter, not for a pressure";
    return;
  }
  const UsablePoints points = usable(run);
  if (points.depth.size() < fewest_points_to_fit) {
    run.fit_skipped = too_few(run, points.depth.size());
    return;
  }
  const Eq16 closed_form{run.a_A, run.nu};
  if (!(std::isfinite(closed_form.q()) && run.a_A > 0)) {
    run.fit_skipped = fmt::format("radius {} Å and Poisson's ratio {} give no Eq. 16", run.a_A, run.nu);
    return;
  }
  const AnyCurveModel model = any_model(closed_form);
  auto found = fit_curve(model, points.depth, points.force);
  if (const auto* reason = std::get_if<std::string>(&found)) {
    run.fit_skipped = *reason;
    return;
  }
  run.fits.push_back(std::get<Fit>(std::move(found)));
  run.fits.back().model = "eq16";
  run.scan = scan_window(model, points.depth, points.force);
}

namespace {

const Run* like_for_like(const Result& result, const Run& run) {
  if (run.model == Model::membrane && run.constants != Constants::calibrated) return &run;
  const auto twin = std::ranges::find_if(result.runs, [&](const Run& other) {
    return other.model == Model::membrane && other.constants == Constants::card && other.load == run.load;
  });
  return twin == result.runs.end() ? nullptr : &*twin;
}

/// Eq. 16 fitted to the membrane's curve at the given depths, as far as it reaches.
std::optional<Fit> membranes_fit(const Run& membrane, const std::vector<double>& depths) {
  try {
    const Curve curve(membrane);
    std::vector<double> depth, force;
    for (const double d : depths) {
      if (const auto f = curve.at(d)) {
        depth.push_back(d);
        force.push_back(*f);
      }
    }
    if (depth.size() < fewest_points_to_fit || depth.size() < depths.size() / 2) return std::nullopt;
    CurveFitOptions plain;
    plain.bootstrap_samples = 0;
    auto found = fit_curve(any_model(Eq16{membrane.a_A, membrane.nu}), depth, force, plain);
    if (auto* fit = std::get_if<Fit>(&found)) return std::move(*fit);
  } catch (const std::invalid_argument&) {  // no curve
  }
  return std::nullopt;
}

}  // namespace

void add_biases(Result& result) {
  for (Run& run : result.runs) {
    Fit* fit = closed_form_fit(run.fits);
    const Run* membrane = fit ? like_for_like(result, run) : nullptr;
    if (!membrane) continue;
    const auto read = membranes_fit(*membrane, fit->fitted_depth_A);
    if (read) fit->bias = fit_bias(*fit, *read, membrane->Eh_eV_per_A2, membrane->pretension_eV_per_A2);
  }
}

void add_direct_fits(Result& result) {
  for (Run& run : result.runs) {
    if (!closed_form_fit(run.fits)) continue;
    const UsablePoints points = usable(run);
    const MembraneTip tip{run.a_A, run.nu, run.tip_A, run.record_radius_A, run.load == LoadKind::sphere};
    const MembraneFitReport report = fit_membrane(tip, points.depth, points.force, {});
    if (report.converged) run.fits.push_back(report.fit);
  }
}

}  // namespace validate
