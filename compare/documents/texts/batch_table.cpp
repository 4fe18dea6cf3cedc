#include "compare/documents/texts/batch_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "compare/documents/texts/numbers.hpp"

namespace validate {
namespace {

std::string shown(double eV_per_A2) { return number(in_N_per_m(eV_per_A2), "{:.1f}"); }

std::string row(const CaseOutcome& one, const Run& run) {
  const Result& r = *one.summary;
  const Fit *fit = closed_form_fit(run.fits), *quoted = recommended_fit(run.fits);
  const bool judged = r.agreement && r.agreement->load == run.load;
  return fmt::format(
      "{:<14}{:>7g}{:>9} {:<8}{:>15}{:>15}{:>16}{:>16}{:>11}  {}\n",
      std::filesystem::path(one.potential).stem().string(), one.radius_A, r.card ? shown(r.card->Eh_eV_per_A2) : "-",
      run.load, fit ? with_error_N_per_m(fit->Eh_eV_per_A2, fit->Eh_stderr_eV_per_A2, 1) : "-",
      quoted ? with_error_N_per_m(quoted->Eh_eV_per_A2, quoted->Eh_stderr_eV_per_A2, 1) : "-",
      fit ? with_error_N_per_m(fit->pretension_eV_per_A2, fit->pretension_stderr_eV_per_A2, 3) : "-",
      quoted ? with_error_N_per_m(quoted->pretension_eV_per_A2, quoted->pretension_stderr_eV_per_A2, 3) : "-",
      judged ? fmt::format("{:.2f}", 100 * r.agreement->max_relative_difference) : "",
      judged ? to_string(r.agreement->outcome) : "");
}

}  // namespace

std::string batch_table(const Result& batch) {
  std::string text =
      fmt::format("{:<14}{:>7}{:>9} {:<8}{:>15}{:>15}{:>16}{:>16}{:>11}  {}\n", "potential", "R", "card", "load",
                  "Eq. 16 E·h", "quoted E·h", "Eq. 16 tension", "quoted tension", "largest", "verdict");
  text += fmt::format("{:<14}{:>7}{:>9} {:<8}{:>15}{:>15}{:>16}{:>16}{:>11}\n", "", "Å", "N/m", "", "N/m ± error",
                      "N/m ± error", "N/m ± error", "N/m ± error", "diff. %");
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
