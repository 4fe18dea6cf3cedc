#include "compare/documents/texts/measured_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "compare/base/units.hpp"
#include "compare/documents/texts/ladder.hpp"
#include "compare/documents/texts/numbers.hpp"

namespace validate {
namespace {

std::string interval(const std::array<double, 2>& ends, const char* format) {
  return number(in_N_per_m(ends[0]), format) + " … " + number(in_N_per_m(ends[1]), format);
}

/// What the standard errors come from, in shares of the variance of E·h.
std::string sources_in_words(const Fit& fit) {
  double total = 0;
  for (const ErrorSource& source : fit.sources) total += std::pow(source.Eh_eV_per_A2, 2);
  std::string text;
  for (const ErrorSource& source : fit.sources) {
    const double share = std::pow(source.Eh_eV_per_A2, 2) / total;
    if (!(share > 0.01)) continue;
    text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", source.name, 100 * share);
  }
  return text;
}

ErrorSource noise_of(const Fit& fit) {
  const auto found = std::ranges::find(fit.sources, "noise", &ErrorSource::name);
  return found == fit.sources.end() ? ErrorSource{} : *found;
}

void add_fit(std::string& text, const Fit& fit) {
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "  {:<18}E·h {:>7} N/m  (95 %: {})   pretension {:>7} N/m  (95 %: {})\n",
                 model_in_words(fit.model) + (fit.recommended ? " *" : ""),
                 number(in_N_per_m(fit.Eh_eV_per_A2), "{:.1f}"), interval(fit.Eh_interval_eV_per_A2, "{:.1f}"),
                 number(in_N_per_m(fit.pretension_eV_per_A2), "{:.3f}"),
                 interval(fit.pretension_interval_eV_per_A2, "{:.3f}"));
  fmt::format_to(out, "    {} points, misfit {:.2f} % of the largest force, correlation {:.3f}", fit.points,
                 100 * fit.rms_relative, fit.correlation);
  if (std::isfinite(fit.chi2_per_dof)) fmt::format_to(out, ", χ²/ν {:.2f}", fit.chi2_per_dof);
  if (fit.sigma_force_nN) fmt::format_to(out, ", noise {:.3g} nN", *fit.sigma_force_nN);
  if (fit.sigma_depth_nm && *fit.sigma_depth_nm > 0) fmt::format_to(out, " and {:.3g} nm", *fit.sigma_depth_nm);
  text += '\n';
  if (fit.contact_nm)
    fmt::format_to(out, "    contact at {:.3f} ± {:.3f} nm\n", *fit.contact_nm,
                   fit.contact_stderr_nm.value_or(not_known));
  if (fit.force_zero_nN)
    fmt::format_to(out, "    zero of force at {:.3f} ± {:.3f} nN\n", *fit.force_zero_nN,
                   fit.force_zero_stderr_nN.value_or(not_known));
  if (fit.slope_nN_per_nm) fmt::format_to(out, "    slope of the baseline {:.4f} nN/nm\n", *fit.slope_nN_per_nm);
  fmt::format_to(out, "    errors of E·h come from: {}\n", sources_in_words(fit));
  if (fit.Eh_bootstrap_eV_per_A2 && fit.pretension_bootstrap_eV_per_A2)
    fmt::format_to(out,
                   "    noise alone: ± {:.1f} and ± {:.3f} N/m; by refits to drawn noise: ± {:.1f} and ± {:.3f} N/m\n",
                   in_N_per_m(noise_of(fit).Eh_eV_per_A2), in_N_per_m(noise_of(fit).pretension_eV_per_A2),
                   in_N_per_m(*fit.Eh_bootstrap_eV_per_A2), in_N_per_m(*fit.pretension_bootstrap_eV_per_A2));
  if (fit.torn_at_A)
    fmt::format_to(out, "    its law ends at a depth of {:.4g} nm: deeper points are left out of this fit\n",
                   *fit.torn_at_A / 10);
  if (fit.bias)
    fmt::format_to(out, "    from the sheet marked * it would read E·h {:+.1f} % and pretension {:+.3f} N/m off\n",
                   100 * (fit.bias->Eh_read_eV_per_A2 / fit.bias->Eh_true_eV_per_A2 - 1),
                   in_N_per_m(fit.bias->pretension_read_eV_per_A2 - fit.bias->pretension_true_eV_per_A2));
  for (const std::string& warning : fit.warnings) text += "    warning: " + warning + "\n";
}

}  // namespace

std::string measured_text(const FittedCurve& curve) {
  std::string text = fmt::format("{}: {} of {} points ({} against {})\n", curve.file, curve.depth_A.size(),
                                 curve.points_read, curve.force_column, curve.depth_column);
  if (curve.baseline_eV_per_A != 0)
    fmt::format_to(std::back_inserter(text), "  baseline taken off: {:.4g} nN\n",
                   curve.baseline_eV_per_A * nN_per_eV_per_A);
  if (const Fit* fit = recommended_fit(curve.fits))
    fmt::format_to(std::back_inserter(text), "  E·h = {:.1f} ± {:.1f} N/m, pretension = {:.3f} ± {:.3f} N/m ({})\n",
                   in_N_per_m(fit->Eh_eV_per_A2), in_N_per_m(fit->Eh_stderr_eV_per_A2),
                   in_N_per_m(fit->pretension_eV_per_A2), in_N_per_m(fit->pretension_stderr_eV_per_A2),
                   model_in_words(fit->model));
  if (!curve.continuum.empty()) text += "  " + curve.continuum + "\n";
  for (const Fit& fit : curve.fits) add_fit(text, fit);
  if (!curve.skipped.empty()) text += "  not fitted: " + curve.skipped + "\n";
  for (const std::string& note : curve.notes) text += "  note: " + note + "\n";
  return text;
}

}  // namespace validate
