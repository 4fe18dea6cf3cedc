#include "compare/documents/plots/measured_curve_plot.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <utility>

#include "compare/base/units.hpp"
#include "compare/fitting/fit_intervals.hpp"
#include "compare/fitting/models/list.hpp"

namespace validate {
namespace {

constexpr double nm_per_A = 0.1;

std::vector<double> times(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

/// In nm and nN, in order of the depth.
PlotCurve force_curve(const std::string& name, const std::vector<double>& depth_A,
                      const std::vector<double>& force_eV_per_A, Colour colour) {
  std::vector<std::size_t> order(std::min(depth_A.size(), force_eV_per_A.size()));
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return depth_A[i]; });
  PlotCurve curve{.name = name, .x = {}, .y = {}, .colour = colour};
  for (const std::size_t i : order) {
    curve.x.push_back(nm_per_A * depth_A[i]);
    curve.y.push_back(nN_per_eV_per_A * force_eV_per_A[i]);
  }
  return curve;
}

PlotCurve with(PlotCurve curve, std::optional<Line> line, std::optional<Points> points) {
  curve.line = line;
  curve.points = points;
  return curve;
}

constexpr Points small{.size = 0.5};
constexpr Line dashed{.dash = Dash::dashed};

/// The fitted closed form, offsets included, as a dense line.
PlotCurve closed_form_curve(const FittedCurve& result) {
  const Fit& fit = *closed_form_fit(result.fits);
  const ModelGeometry geometry{
      .a_A = result.radius_A, .nu = result.nu, .tip_A = result.tip_radius_A, .bending_eV = result.bending_modulus_eV};
  const AnyCurveModel model = with_offsets(closed_form(result.model, "model").make(geometry),
                                           fit.depth_offset_A.has_value(), fit.force_offset_eV_per_A.has_value());
  std::vector<double> parameters = {fit.Eh_eV_per_A2, fit.pretension_eV_per_A2};
  if (fit.depth_offset_A) parameters.push_back(*fit.depth_offset_A);
  if (fit.force_offset_eV_per_A) parameters.push_back(*fit.force_offset_eV_per_A);
  std::vector<double> depth, force;
  for (int i = 1; i <= 200; ++i) {
    depth.push_back(fit.window_A[1] * i / 200);
    force.push_back(model.value(depth.back(), parameters));
  }
  return with(force_curve(result.model, depth, force, colour_of_membrane), Line{}, {});
}

std::string itself(const Fit& direct) { return direct.model + " itself"; }

/// The fit of the continuum itself, back on the curve's zero of force.
PlotCurve direct_curve(const Fit& closed, const Fit& direct) {
  std::vector<double> force = direct.model_force_eV_per_A;
  for (double& f : force) f += closed.force_offset_eV_per_A.value_or(0);
  return with(force_curve(itself(direct), direct.fitted_depth_A, force, Colour::vermilion), dashed, {});
}

Panel force_panel(const char* label, const char* key) {
  return {.title = {},
          .x = {.label = "depth", .unit = "nm", .key = "depth_nm", .low = 0},
          .y = {.label = label, .unit = "nN", .key = key},
          .legend = Legend::left_top};
}

/// A parameter against the window. It goes to very different values in short windows: the panel shows the fitted value
/// ± 30 %, or 8 errors.
Panel scan_panel(const FittedCurve& result, const std::string& model, const Axis& axis,
                 const std::vector<double>& scanned, double value, double error, const Fit* direct,
                 double direct_value) {
  const double reach = std::max(0.3 * std::abs(value), 8 * error);
  Panel panel{.title = {},
              .x = {.label = "largest depth fitted", .unit = "nm", .key = "depth_max_nm", .low = 0},
              .y = axis,
              .legend = Legend::left_top};
  panel.y.low = N_per_m_per_eV_per_A2 * (value - reach);
  panel.y.high = N_per_m_per_eV_per_A2 * (value + reach);
  panel.curves.push_back({.name = model,
                          .x = times(result.scan.depth_max_A, nm_per_A),
                          .y = times(scanned, N_per_m_per_eV_per_A2),
                          .colour = colour_of_membrane,
                          .line = Line{.width = 1},
                          .points = small});
  if (direct)
    panel.curves.push_back({.name = itself(*direct),
                            .x = {0, nm_per_A * direct->window_A[1]},
                            .y = std::vector<double>(2, N_per_m_per_eV_per_A2 * direct_value),
                            .colour = Colour::vermilion,
                            .line = dashed});
  return panel;
}

}  // namespace

Plot measured_plot(const FittedCurve& result) {
  const Fit& fit = *closed_form_fit(result.fits);
  Panel force = force_panel("force", "force_nN"), residual = force_panel("residual", "residual_nN");
  force.curves = {with(force_curve("data", result.depth_A, result.force_eV_per_A, Colour::grey), {}, small),
                  closed_form_curve(result)};
  const Fit* direct = continuum_fit(result.fits);
  if (direct) force.curves.push_back(direct_curve(fit, *direct));
  residual.curves = {with(
      force_curve("data − " + result.model, fit.fitted_depth_A, fit.residual_eV_per_A, colour_of_membrane), {}, small)};
  residual.marks = {{.along = Along::y, .at = 0}};
  const double pretension_error = std::max(fit.pretension_stderr_eV_per_A2, std::abs(fit.pretension_eV_per_A2) / 10);
  return {
      .title = std::filesystem::path(result.file).filename().string(),
      .panels = {std::move(force), std::move(residual),
                 scan_panel(result, result.model, {.label = "E·h", .unit = "N/m", .key = "Eh_N_per_m"},
                            result.scan.Eh_eV_per_A2, fit.Eh_eV_per_A2, fit.Eh_stderr_eV_per_A2, direct,
                            direct ? direct->Eh_eV_per_A2 : 0),
                 scan_panel(result, result.model, {.label = "pretension", .unit = "N/m", .key = "pretension_N_per_m"},
                            result.scan.pretension_eV_per_A2, fit.pretension_eV_per_A2, pretension_error, direct,
                            direct ? direct->pretension_eV_per_A2 : 0)},
      .columns = 2,
      .width = 1000,
      .height = 760};
}

}  // namespace validate
