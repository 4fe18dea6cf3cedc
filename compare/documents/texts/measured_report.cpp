#include "compare/documents/texts/measured_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "compare/documents/texts/numbers.hpp"

namespace validate {
namespace {

void add_row(std::string& text, const char* what, double value, double error, int digits,
             const std::string& more = {}) {
  fmt::format_to(std::back_inserter(text), "  {:<26}{:>10.{}f} ± {:<8.{}f} N/m   ({:.4f} eV/Å²){}\n", what,
                 in_N_per_m(value), digits, in_N_per_m(error), digits, value, more);
}

std::string interval(const std::array<double, 2>& ends, int digits) {
  return fmt::format("  95 %: {:.{}f} … {:.{}f}", in_N_per_m(ends[0]), digits, in_N_per_m(ends[1]), digits);
}

void add_continuum(std::string& text, const FittedCurve& curve) {
  const Fit* direct = continuum_fit(curve.fits);
  const bool plain = direct && direct->model == fitted_membrane;
  if (!direct) return;
  if (!plain) text += "  " + curve.continuum + ", fitted itself:\n";
  add_row(text, plain ? "membrane itself: E·h" : "sheet itself: E·h", direct->Eh_eV_per_A2, direct->Eh_stderr_eV_per_A2,
          1);
  add_row(text, "  pretension", direct->pretension_eV_per_A2, direct->pretension_stderr_eV_per_A2, 3,
          fmt::format("  rms {:.2f} %", 100 * direct->rms_relative));
  const Fit& fit = *closed_form_fit(curve.fits);
  if (direct->torn_at_A)
    fmt::format_to(
        std::back_inserter(text),
        "  by its law the sheet tears beyond a depth of {:.4g} nm: {} deeper points are left out of this fit\n",
        *direct->torn_at_A / 10, fit.points - direct->points);
  if (!fit.bias) return;
  const FitBias& bias = *fit.bias;
  fmt::format_to(std::back_inserter(text),
                 "  the closed form reads from that: E·h {:.1f} N/m ({:+.1f} %), pretension {:.3f} N/m\n",
                 in_N_per_m(bias.Eh_read_eV_per_A2), 100 * (bias.Eh_read_eV_per_A2 / bias.Eh_true_eV_per_A2 - 1),
                 in_N_per_m(bias.pretension_read_eV_per_A2));
  fmt::format_to(std::back_inserter(text), "  corrected by that: E·h {:.1f} N/m, pretension {:.3f} N/m\n",
                 in_N_per_m(bias.Eh_corrected_eV_per_A2), in_N_per_m(bias.pretension_corrected_eV_per_A2));
}

void add_offsets(std::string& text, const Fit& fit) {
  if (fit.depth_offset_A)
    fmt::format_to(std::back_inserter(text), "  contact at {:.3f} ± {:.3f} nm\n", *fit.depth_offset_A / 10,
                   fit.depth_offset_stderr_A.value_or(not_known) / 10);
  if (fit.force_offset_eV_per_A)
    fmt::format_to(std::back_inserter(text), "  zero of force at {:.3f} ± {:.3f} nN\n",
                   *fit.force_offset_eV_per_A * nN_per_eV_per_A,
                   fit.force_offset_stderr_eV_per_A.value_or(not_known) * nN_per_eV_per_A);
}

}  // namespace

std::string measured_text(const FittedCurve& curve) {
  const Fit& fit = *closed_form_fit(curve.fits);
  std::string text = fmt::format("{}: {} of {} points ({} against {}), depth {:.4g} … {:.4g} nm\n", curve.file,
                                 fit.points, curve.points_read, curve.force_column, curve.depth_column,
                                 fit.window_A[0] / 10, fit.window_A[1] / 10);
  if (curve.baseline_eV_per_A != 0)
    fmt::format_to(std::back_inserter(text), "  baseline taken off: {:.4g} nN\n",
                   curve.baseline_eV_per_A * nN_per_eV_per_A);
  add_row(text, (curve.model + ": E·h").c_str(), fit.Eh_eV_per_A2, fit.Eh_stderr_eV_per_A2, 1,
          interval(fit.Eh_interval_eV_per_A2, 1));
  add_row(text, "  pretension", fit.pretension_eV_per_A2, fit.pretension_stderr_eV_per_A2, 3,
          interval(fit.pretension_interval_eV_per_A2, 3));
  add_offsets(text, fit);
  fmt::format_to(std::back_inserter(text),
                 "  correlation {:.3f}, condition {:.3g}, R² {:.6f}, rms {:.2f} % of the largest force, "
                 "bootstrap ± {:.1f} and ± {:.3f} N/m\n",
                 fit.correlation, fit.condition_number, fit.r_squared, 100 * fit.rms_relative,
                 in_N_per_m(fit.Eh_bootstrap_eV_per_A2), in_N_per_m(fit.pretension_bootstrap_eV_per_A2));
  add_continuum(text, curve);
  if (!curve.direct_skipped.empty()) text += "  no fit of the sheet itself: " + curve.direct_skipped + "\n";
  for (const std::string& warning : fit.warnings) text += "  warning: " + warning + "\n";
  return text;
}

}  // namespace validate
