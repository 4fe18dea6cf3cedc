#include "compare/documents/texts/measured_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "compare/base/units.hpp"
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

}  // namespace validate
