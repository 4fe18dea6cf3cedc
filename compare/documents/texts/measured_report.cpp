#include "compare/documents/texts/measured_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "compare/base/units.hpp"
#include "compare/documents/plots/figure.hpp"
#include "compare/documents/plots/gnuplot.hpp"
#include "compare/documents/texts/summary_json.hpp"
#include "compare/fitting/fit_intervals.hpp"

namespace validate {
namespace {

double in_N_per_m(double eV_per_A2) { return eV_per_A2 * N_per_m_per_eV_per_A2; }

void add_row(std::string& text, const char* what, double value, double error, int digits,
             const std::string& more = {}) {
  fmt::format_to(std::back_inserter(text), "  {:<26}{:>10.{}f} ± {:<8.{}f} N/m   ({:.4f} eV/Å²){}\n", what,
                 in_N_per_m(value), digits, in_N_per_m(error), digits, value, more);
}

std::string interval(const std::array<double, 2>& ends, int digits) {
  return fmt::format("  95 %: {:.{}f} … {:.{}f}", in_N_per_m(ends[0]), digits, in_N_per_m(ends[1]), digits);
}

void add_corrections(std::string& text, const MeasuredResult& result, const MeasuredOptions& options) {
  const Fit& fit = result.fit;
  if (!fit.direct) return;
  if (options.physics) text += "  " + options.physics->name + ", fitted itself:\n";
  add_row(text, options.physics ? "sheet itself: E·h" : "membrane itself: E·h", fit.direct->Eh_eV_per_A2,
          fit.direct->Eh_stderr_eV_per_A2, 1);
  add_row(text, "  pretension", fit.direct->pretension_eV_per_A2, fit.direct->pretension_stderr_eV_per_A2, 3,
          fmt::format("  rms {:.2f} %", 100 * fit.direct->rms_relative));
  if (result.torn_at_A)
    fmt::format_to(
        std::back_inserter(text),
        "  by its law the sheet tears beyond a depth of {:.4g} nm: {} deeper points are left out of this fit\n",
        *result.torn_at_A / 10, fit.points - static_cast<int>(result.direct_depth_A.size()));
  if (!fit.bias) return;
  const FitBias& bias = *fit.bias;
  fmt::format_to(std::back_inserter(text),
                 "  the closed form reads from that: E·h {:.1f} N/m ({:+.1f} %), pretension {:.3f} N/m\n",
                 in_N_per_m(bias.Eh_read_eV_per_A2), 100 * (bias.Eh_read_eV_per_A2 / bias.Eh_true_eV_per_A2 - 1),
                 in_N_per_m(bias.pretension_read_eV_per_A2));
  fmt::format_to(std::back_inserter(text), "  corrected by that: E·h {:.1f} N/m, pretension {:.3f} N/m\n",
                 in_N_per_m(bias.Eh_corrected_eV_per_A2), in_N_per_m(bias.pretension_corrected_eV_per_A2));
}

}  // namespace

std::string measured_text(const MeasuredResult& result, const MeasuredOptions& options) {
  const Fit& fit = result.fit;
  std::string text =
      fmt::format("{}: {} of {} points ({} against {}), depth {:.4g} … {:.4g} nm\n", result.curve.file.string(),
                  fit.points, result.curve.depth_A.size(), result.curve.force_column, result.curve.depth_column,
                  fit.window_A[0] / 10, fit.window_A[1] / 10);
  if (result.baseline_eV_per_A != 0)
    fmt::format_to(std::back_inserter(text), "  baseline taken off: {:.4g} nN\n",
                   result.baseline_eV_per_A * nN_per_eV_per_A);
  add_row(text, (options.model + ": E·h").c_str(), fit.Eh_eV_per_A2, fit.Eh_stderr_eV_per_A2, 1,
          interval(fit.Eh_interval_eV_per_A2, 1));
  add_row(text, "  pretension", fit.pretension_eV_per_A2, fit.pretension_stderr_eV_per_A2, 3,
          interval(fit.pretension_interval_eV_per_A2, 3));
  if (fit.depth_offset_A)
    fmt::format_to(std::back_inserter(text), "  contact at {:.3f} ± {:.3f} nm\n", *fit.depth_offset_A / 10,
                   fit.depth_offset_stderr_A.value_or(not_known) / 10);
  if (fit.force_offset_eV_per_A)
    fmt::format_to(std::back_inserter(text), "  zero of force at {:.3f} ± {:.3f} nN\n",
                   *fit.force_offset_eV_per_A * nN_per_eV_per_A,
                   fit.force_offset_stderr_eV_per_A.value_or(not_known) * nN_per_eV_per_A);
  fmt::format_to(std::back_inserter(text),
                 "  correlation {:.3f}, condition {:.3g}, R² {:.6f}, rms {:.2f} % of the largest force, "
                 "bootstrap ± {:.1f} and ± {:.3f} N/m\n",
                 fit.correlation, fit.condition_number, fit.r_squared, 100 * fit.rms_relative,
                 in_N_per_m(fit.Eh_bootstrap_eV_per_A2), in_N_per_m(fit.pretension_bootstrap_eV_per_A2));
  add_corrections(text, result, options);
  if (!fit.direct)
    text += fmt::format("  no fit of the {} itself: ", options.physics ? "sheet" : "membrane") + result.direct_skipped +
            "\n";
  for (const std::string& warning : fit.warnings) text += "  warning: " + warning + "\n";
  return text;
}

nlohmann::ordered_json measured_document(const std::vector<MeasuredResult>& results,
                                         const std::vector<MeasuredOptions>& options, const std::string& command_line) {
  using Json = nlohmann::ordered_json;
  Json document{{"schema", summary_schema}, {"command_line", command_line}, {"curves", Json::array()}};
  for (std::size_t i = 0; i < results.size(); ++i) {
    const MeasuredResult& result = results[i];
    const ModelGeometry& geometry = options[i].geometry;
    Json curve;
    curve["file"] = result.curve.file.string();
    curve["model"] = options[i].model;
    curve["radius_A"] = geometry.a_A;
    curve["nu"] = geometry.nu;
    curve["tip"] = geometry.tip_A == 0 ? "point" : options[i].sphere ? "sphere" : "disc";
    curve["tip_radius_A"] = geometry.tip_A;
    curve["depth_column"] = result.curve.depth_column;
    curve["force_column"] = result.curve.force_column;
    curve["baseline_eV_per_A"] = result.baseline_eV_per_A;
    curve["depth_A"] = result.depth_A;
    curve["force_eV_per_A"] = result.force_eV_per_A;
    curve["fit"] = fit_document(result.fit);
    if (!result.direct_skipped.empty()) curve["direct_skipped"] = result.direct_skipped;
    if (result.torn_at_A) curve["direct_torn_at_A"] = *result.torn_at_A;
    curve["window_scan"] = {{"depth_max_A", result.scan.depth_max_A},
                            {"Eh_eV_per_A2", result.scan.Eh_eV_per_A2},
                            {"pretension_eV_per_A2", result.scan.pretension_eV_per_A2}};
    document["curves"].push_back(std::move(curve));
  }
  return document;
}

namespace {

std::string block(const char* name, const std::vector<double>& x, const std::vector<double>& y, double x_factor,
                  double y_factor) {
  std::vector<std::size_t> order(std::min(x.size(), y.size()));
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::sort(order, {}, [&](std::size_t i) { return x[i]; });
  std::string text = fmt::format("${} << EOD\n", name);
  for (const std::size_t i : order)
    fmt::format_to(std::back_inserter(text), "{} {}\n", x_factor * x[i], y_factor * y[i]);
  return text + "EOD\n";
}

/// The fitted closed form, offsets included, as a dense line.
std::string model_block(const MeasuredResult& result, const MeasuredOptions& options) {
  const Fit& fit = result.fit;
  const AnyCurveModel model = with_offsets(closed_form(options.model, "--model").make(options.geometry),
                                           fit.depth_offset_A.has_value(), fit.force_offset_eV_per_A.has_value());
  std::vector<double> parameters = {fit.Eh_eV_per_A2, fit.pretension_eV_per_A2};
  if (fit.depth_offset_A) parameters.push_back(*fit.depth_offset_A);
  if (fit.force_offset_eV_per_A) parameters.push_back(*fit.force_offset_eV_per_A);
  std::vector<double> depth, force;
  for (int i = 1; i <= 200; ++i) {
    depth.push_back(fit.window_A[1] * i / 200);
    force.push_back(model.value(depth.back(), parameters));
  }
  return block("model", depth, force, 0.1, nN_per_eV_per_A);
}

std::vector<double> lifted(std::vector<double> force, const Fit& fit) {
  for (double& f : force) f += fit.force_offset_eV_per_A.value_or(0);
  return force;
}

std::string scan_block(const MeasuredResult& result) {
  std::string text = "$scan << EOD\n";
  for (std::size_t i = 0; i < result.scan.depth_max_A.size(); ++i)
    fmt::format_to(std::back_inserter(text), "{} {} {}\n", result.scan.depth_max_A[i] / 10,
                   in_N_per_m(result.scan.Eh_eV_per_A2[i]), in_N_per_m(result.scan.pretension_eV_per_A2[i]));
  return text + "EOD\n";
}

/// E·h and pretension go to very different values in short windows: the panels show the fitted value ± 30 %,
/// or 8 errors.
std::string around(double value, double error) {
  const double reach = std::max(0.3 * std::abs(value), 8 * error);
  return fmt::format("[{}:{}]", in_N_per_m(value - reach), in_N_per_m(value + reach));
}

}  // namespace

std::optional<std::string> draw_measured(const MeasuredResult& result, const MeasuredOptions& options,
                                         const std::filesystem::path& folder, const std::string& name) {
  const Fit& fit = result.fit;
  const bool direct = fit.direct.has_value();
  std::string text =
      block("data", result.depth_A, result.force_eV_per_A, 0.1, nN_per_eV_per_A) + model_block(result, options) +
      block("residual", fit.fitted_depth_A, fit.residual_eV_per_A, 0.1, nN_per_eV_per_A) + scan_block(result);
  if (direct)
    text += block("membrane", result.direct_depth_A, lifted(result.direct_force_eV_per_A, fit), 0.1, nN_per_eV_per_A);
  text += fmt::format(
      "set multiplot layout 2,2 title {}\n"
      "set border 3 lw 1\nset tics nomirror out\nset grid lc rgb '#e4e4e4' lw 1 lt 1\n"
      "set xlabel 'depth (nm)'\nset xrange [0:*]\n"
      "set key inside left top Left reverse samplen 2 font ',10'\n"
      "set ylabel 'force (nN)'\n"
      "plot $data using 1:2 with points pt 7 ps 0.5 lc rgb '#777777' title 'data', \\\n"
      "     $model using 1:2 with lines lw 1.5 lc rgb '#0072B2' title {}{}\n"
      "set ylabel 'residual (nN)'\n"
      "plot $residual using 1:2 with points pt 7 ps 0.5 lc rgb '#0072B2' title {}{}, 0 with lines lc rgb "
      "'black' lw 0.6 notitle\n",
      gnuplot_quoted(result.curve.file.filename().string()), gnuplot_quoted(options.model),
      direct ? ", \\\n     $membrane using 1:2 with lines lw 1.5 dt '-' lc rgb '#D55E00' title 'membrane itself'" : "",
      gnuplot_quoted("data − " + options.model), "");
  text += fmt::format(
      "set xlabel 'largest depth fitted (nm)'\nset ylabel 'E·h (N/m)'\nset yrange {}\n"
      "plot $scan using 1:2 with linespoints pt 7 ps 0.5 lc rgb '#0072B2' title {}{}\n"
      "set ylabel 'pretension (N/m)'\nset yrange {}\n"
      "plot $scan using 1:3 with linespoints pt 7 ps 0.5 lc rgb '#0072B2' title {}{}\nunset multiplot\n",
      around(fit.Eh_eV_per_A2, fit.Eh_stderr_eV_per_A2), gnuplot_quoted(options.model),
      direct ? fmt::format(", {} with lines lw 1.5 dt '-' lc rgb '#D55E00' title 'membrane itself'",
                           in_N_per_m(fit.direct->Eh_eV_per_A2))
             : "",
      around(fit.pretension_eV_per_A2,
             std::max(fit.pretension_stderr_eV_per_A2, std::abs(fit.pretension_eV_per_A2) / 10)),
      gnuplot_quoted(options.model),
      direct ? fmt::format(", {} with lines lw 1.5 dt '-' lc rgb '#D55E00' title 'membrane itself'",
                           in_N_per_m(fit.direct->pretension_eV_per_A2))
             : "");
  return draw(text, folder, name, {1000, 760});
}

}  // namespace validate
