#include "compare/documents/texts/batch_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <vector>

#include "compare/documents/texts/numbers.hpp"

namespace validate {
namespace {

std::string shown(double eV_per_A2) { return number(in_N_per_m(eV_per_A2), "{:.1f}"); }

std::vector<std::string> cells(const CaseOutcome& one, const Run& run) {
  const Result& r = *one.summary;
  const Fit *fit = closed_form_fit(run.fits), *quoted = recommended_fit(run.fits);
  const bool judged = r.agreement && r.agreement->load == run.load;
  return {std::filesystem::path(one.potential).stem().string(),
          fmt::format("{:g}", one.radius_A),
          r.card ? shown(r.card->Eh_eV_per_A2) : "-",
          std::string(to_string(run.load)),
          fit ? with_error_N_per_m(fit->Eh_eV_per_A2, fit->Eh_stderr_eV_per_A2, 1) : "-",
          quoted ? with_error_N_per_m(quoted->Eh_eV_per_A2, quoted->Eh_stderr_eV_per_A2, 1) : "-",
          fit ? with_error_N_per_m(fit->pretension_eV_per_A2, fit->pretension_stderr_eV_per_A2, 3) : "-",
          quoted ? with_error_N_per_m(quoted->pretension_eV_per_A2, quoted->pretension_stderr_eV_per_A2, 3) : "-",
          judged ? fmt::format("{:.2f}", 100 * r.agreement->max_relative_difference) : "",
          judged ? std::string(to_string(r.agreement->outcome)) : ""};
}

}  // namespace

std::string batch_table(const Result& batch, int width) {
  TextTable table({{.heading = "potential", .align = Align::left},
                   {.heading = "R", .unit = "Å"},
                   {.heading = "card", .unit = "N/m", .rank = 2},
                   {.heading = "load", .align = Align::left},
                   {.heading = "Eq. 16 E·h", .unit = "N/m", .rank = 3},
                   {.heading = "quoted E·h", .unit = "N/m"},
                   {.heading = "Eq. 16 tension", .unit = "N/m", .rank = 4},
                   {.heading = "quoted tension", .unit = "N/m", .rank = 1},
                   {.heading = "difference", .unit = "%"},
                   {.heading = "verdict", .align = Align::left}});
  for (const CaseOutcome& one : batch.cases) {
    if (!one.summary) {
      table.add_line(fmt::format("{}  {:g}  failed, exit code {}: see {}.log", one.potential, one.radius_A,
                                 one.exit_code, one.folder));
      continue;
    }
    for (const Run& run : one.summary->runs)
      if (run.is_atomistic()) table.add(cells(one, run));
  }
  return table.text(width);
}

}  // namespace validate
