#include "compare/documents/plots/measured_curve_plot.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <utility>

#include "compare/base/units.hpp"

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

/// A fitted model at the points' depths.
PlotCurve fitted_curve(const Fit& fit, std::size_t index) {
  const std::string name = fit.model + (of_continuum(fit) ? " itself" : "");
  return with(force_curve(name, fit.fitted_depth_A, fit.model_force_eV_per_A, nth_colour(index)),
              Line{.dash = index == 0 ? Dash::solid : Dash::dashed}, {});
}

Panel force_panel(const char* label, const char* key) {
  return {.title = {},
          .x = {.label = "depth", .unit = "nm", .key = "depth_nm", .low = 0},
          .y = {.label = label, .unit = "nN", .key = key},
          .legend = Legend::left_top};
}

/// A parameter of the closed form against the window, and the fit to quote beside it. It goes to very different values
/// in short windows: the panel shows the fitted value ± 30 %, or 8 errors.
Panel scan_panel(const WindowScan& scan, const std::string& model, const Axis& axis, const std::vector<double>& scanned,
                 double value, double error, const Fit* direct, double direct_value) {
  const double reach = std::max(0.3 * std::abs(value), 8 * error);
  Panel panel{.title = {},
              .x = {.label = "largest depth fitted", .unit = "nm", .key = "depth_max_nm", .low = 0},
              .y = axis,
              .legend = Legend::left_top};
  panel.y.low = N_per_m_per_eV_per_A2 * (value - reach);
  panel.y.high = N_per_m_per_eV_per_A2 * (value + reach);
  panel.curves.push_back({.name = model,
                          .x = times(scan.depth_max_A, nm_per_A),
                          .y = times(scanned, N_per_m_per_eV_per_A2),
                          .colour = colour_of_membrane,
                          .line = Line{.width = 1},
                          .points = small});
  if (direct)
    panel.curves.push_back({.name = direct->model + " itself",
                            .x = {0, nm_per_A * direct->window_A[1]},
                            .y = std::vector<double>(2, N_per_m_per_eV_per_A2 * direct_value),
                            .colour = Colour::vermilion,
                            .line = dashed});
  return panel;
}

std::vector<double> baseline_at(const CurvePreparation& p, const std::vector<double>& height_A) {
  std::vector<double> force;
  for (const double z : height_A) force.push_back(p.level_eV_per_A + p.tilt_eV_per_A2 * (z - p.contact_A));
  return force;
}

/// What the instrument wrote, with what is taken off.
Panel raw_panel(const CurvePreparation& p) {
  Panel panel{.title = "as recorded",
              .x = {.label = "height, towards the sample", .unit = "nm", .key = "height_nm"},
              .y = {.label = "force", .unit = "nN", .key = "force_nN"},
              .legend = Legend::left_top};
  panel.curves = {with(force_curve("raw", p.raw_height_A, p.raw_force_eV_per_A, Colour::grey), {}, small),
                  with(force_curve("baseline", p.raw_height_A, baseline_at(p, p.raw_height_A), Colour::vermilion),
                       Line{.width = 1}, {})};
  // Heights count from anywhere: in um their numbers stay short.
  panel.x.unit = "um";
  panel.x.key = "height_um";
  constexpr double um_per_nm = 1e-3;
  for (PlotCurve& curve : panel.curves) curve.x = times(std::move(curve.x), um_per_nm);
  panel.marks = {{.along = Along::x, .at = um_per_nm * nm_per_A * p.contact_A, .dash = Dash::dotted}};
  return panel;
}

/// The stretch about the contact, in the depths of the fit.
Panel contact_panel(const FittedCurve& result, const Fit& quoted) {
  constexpr double share = 0.25;
  const double deepest = nm_per_A * std::ranges::max(result.depth_A), contact = quoted.contact_nm.value_or(0),
               reach = share * (deepest - contact);
  Panel panel = force_panel("force", "force_nN");
  panel.title = "about the contact";
  PlotCurve data = force_curve("data", result.depth_A, result.force_eV_per_A, Colour::grey),
            fit = force_curve(quoted.model, quoted.fitted_depth_A, quoted.model_force_eV_per_A, colour_of_membrane);
  for (PlotCurve* curve : {&data, &fit}) {
    PlotCurve near = *curve;
    near.x.clear(), near.y.clear();
    for (std::size_t i = 0; i < curve->x.size(); ++i)
      if (std::abs(curve->x[i] - contact) < reach) near.x.push_back(curve->x[i]), near.y.push_back(curve->y[i]);
    *curve = std::move(near);
  }
  panel.curves = {with(std::move(data), {}, small), with(std::move(fit), Line{}, {})};
  panel.x.low = contact - reach;
  panel.x.high = contact + reach;
  panel.marks = {{.along = Along::x, .at = contact, .dash = Dash::dotted}};
  return panel;
}

/// A curve of an instrument shows what was done to it first.
void add_preparation(const FittedCurve& result, const Fit& quoted, Plot& plot) {
  if (!result.preparation || result.preparation->raw_height_A.empty()) return;
  plot.panels.insert(plot.panels.begin(), {raw_panel(*result.preparation), contact_panel(result, quoted)});
  plot.height = 1120;
}

}  // namespace

Plot measured_plot(const FittedCurve& result) {
  const Fit& fit = *closed_form_fit(result.fits);
  const Fit* quoted = recommended_fit(result.fits);
  if (!quoted) quoted = &fit;
  Panel force = force_panel("force", "force_nN"), residual = force_panel("residual", "residual_nN");
  force.x.low = residual.x.low = std::nullopt;
  force.curves = {with(force_curve("data", result.depth_A, result.force_eV_per_A, Colour::grey), {}, small)};
  for (std::size_t i = 0; i < result.fits.size(); ++i) force.curves.push_back(fitted_curve(result.fits[i], i));
  residual.curves = {with(
      force_curve("data − " + quoted->model, quoted->fitted_depth_A, quoted->residual_eV_per_A, colour_of_membrane), {},
      small)};
  residual.marks = {{.along = Along::y, .at = 0}};
  const Fit* direct = of_continuum(*quoted) ? quoted : nullptr;
  const double pretension_error = std::max(fit.pretension_stderr_eV_per_A2, std::abs(fit.pretension_eV_per_A2) / 10);
  Plot plot{
      .title = std::filesystem::path(result.file).filename().string(),
      .panels = {std::move(force), std::move(residual),
                 scan_panel(fit.scan, result.model, {.label = "E·h", .unit = "N/m", .key = "Eh_N_per_m"},
                            fit.scan.Eh_eV_per_A2, fit.Eh_eV_per_A2, fit.Eh_stderr_eV_per_A2, direct,
                            direct ? direct->Eh_eV_per_A2 : 0),
                 scan_panel(fit.scan, result.model, {.label = "pretension", .unit = "N/m", .key = "pretension_N_per_m"},
                            fit.scan.pretension_eV_per_A2, fit.pretension_eV_per_A2, pretension_error, direct,
                            direct ? direct->pretension_eV_per_A2 : 0)},
      .columns = 2,
      .width = 1000,
      .height = 760};
  add_preparation(result, *quoted, plot);
  return plot;
}

}  // namespace validate
