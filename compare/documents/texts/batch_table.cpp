#include "compare/documents/texts/batch_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "compare/base/units.hpp"

namespace validate {
namespace {

std::string in_N_per_m(double eV_per_A2, int digits) {
  return std::isfinite(eV_per_A2) ? fmt::format("{:.{}f}", eV_per_A2 * N_per_m_per_eV_per_A2, digits) : "-";
}

std::string with_error(const Fit* fit, double Fit::*value, double Fit::*error, int digits) {
  return fit ? in_N_per_m(fit->*value, digits) + " ± " + in_N_per_m(fit->*error, digits) : "- ± -";
}

std::string row(const CaseOutcome& one, const Run& run) {
  const Result& r = *one.summary;
  const Fit *fit = closed_form_fit(run.fits), *direct = continuum_fit(run.fits);
  const bool judged = r.agreement && r.agreement->load == run.load;
  return fmt::format("{:<14}{:>7g}{:>9} {:<8}{:>15}{:>11}{:>12}{:>15}{:>11}  {}\n",
                     std::filesystem::path(one.potential).stem().string(), one.radius_A,
                     r.card ? in_N_per_m(r.card->Eh_eV_per_A2, 1) : "-", run.load,
                     with_error(fit, &Fit::Eh_eV_per_A2, &Fit::Eh_stderr_eV_per_A2, 1),
                     fit && fit->bias ? in_N_per_m(fit->bias->Eh_corrected_eV_per_A2, 1) : "-",
                     direct ? in_N_per_m(direct->Eh_eV_per_A2, 1) : "-",
                     with_error(fit, &Fit::pretension_eV_per_A2, &Fit::pretension_stderr_eV_per_A2, 3),
                     judged ? fmt::format("{:.2f}", 100 * r.agreement->max_relative_difference) : "",
                     judged ? (r.agreement->outcome == Outcome::agree ? "agreement" : "disagreement") : "");
}

}  // namespace

std::string batch_table(const Result& batch) {
  std::string text = fmt::format("{:<14}{:>7}{:>9} {:<8}{:>15}{:>11}{:>12}{:>15}{:>11}  {}\n", "potential", "R", "card",
                                 "load", "Eq. 16 E·h", "corrected", "membrane", "pretension", "largest", "verdict");
  text += fmt::format("{:<14}{:>7}{:>9} {:<8}{:>15}{:>11}{:>12}{:>15}{:>11}\n", "", "Å", "N/m", "", "N/m ± error",
                      "N/m", "itself N/m", "N/m ± error", "diff. %");
  for (const CaseOutcome& one : batch.cases) {
    if (!one.summary) {
      text += fmt::format("{:<14}{:>7g}  failed, exit code {}: see {}.log\n", one.potential, one.radius_A,
                          one.exit_code, one.folder);
      continue;
    }
    for (const Run& run : one.summary->runs)
      if (run.is_atomistic()) text += row(one, run);
  }
  return text;
}

}  // namespace validate
