#include "compare/documents/texts/report_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "compare/documents/bytes/html.hpp"
#include "compare/documents/texts/card_files.hpp"
#include "compare/documents/texts/ladder.hpp"
#include "compare/documents/texts/many_text.hpp"
#include "compare/documents/texts/measured_report.hpp"
#include "compare/documents/texts/numbers.hpp"

namespace validate {
namespace {

using Row = std::vector<std::string>;
using Rows = std::vector<Row>;

std::string in_N_per_m_text(double eV_per_A2, const char* format) { return number(in_N_per_m(eV_per_A2), format); }

std::string interval(const std::array<double, 2>& ends, const char* format) {
  return in_N_per_m_text(ends[0], format) + " … " + in_N_per_m_text(ends[1], format);
}

std::string heading(int level, const std::string& text) {
  return fmt::format("<h{0}>{1}</h{0}>\n", level, html::escaped(text));
}

std::string folded(const std::string& name, const std::string& text) {
  return "<details><summary>" + name + "</summary>\n" + html::preformatted(text) + "</details>\n";
}

std::string fit_table(const FittedCurve& curve) {
  Rows rows;
  for (const Fit& fit : curve.fits)
    rows.push_back({model_in_words(fit.model) + (fit.recommended ? " *" : ""),
                    in_N_per_m_text(fit.Eh_eV_per_A2, "{:.1f}"), interval(fit.Eh_interval_eV_per_A2, "{:.1f}"),
                    in_N_per_m_text(fit.pretension_eV_per_A2, "{:.3f}"),
                    interval(fit.pretension_interval_eV_per_A2, "{:.3f}"), number(100 * fit.rms_relative, "{:.2f}"),
                    number(fit.chi2_per_dof, "{:.2f}"), fmt::format("{}", fit.points)});
  return heading(2, curve.file) +
         html::table({"model", "E·h (N/m)", "95 %", "pretension (N/m)", "95 %", "misfit (%)", "χ²/ν", "points"}, rows) +
         folded("in words", measured_text(curve));
}

/// A row a curve, sortable, below what they say together.
std::string many_table(const ManyCurves& many) {
  Rows rows;
  for (const CurveRow& r : many.rows)
    rows.push_back({r.file, fmt::format("{}", r.index), in_N_per_m_text(r.Eh_eV_per_A2, "{:.1f}"),
                    interval({r.Eh_low_eV_per_A2, r.Eh_high_eV_per_A2}, "{:.1f}"),
                    in_N_per_m_text(r.pretension_eV_per_A2, "{:.3f}"),
                    interval({r.pretension_low_eV_per_A2, r.pretension_high_eV_per_A2}, "{:.3f}"),
                    number(100 * r.rms_relative, "{:.2f}"), r.skipped});
  return html::preformatted(many_text(many)) +
         html::table({"file", "curve", "E·h (N/m)", "95 %", "pretension (N/m)", "95 %", "misfit (%)", "not used"}, rows,
                     {0, 7});
}

std::string fits(const Result& result) {
  std::string text = result.many ? many_table(*result.many) : "";
  for (const FittedCurve& curve : result.curves) text += fit_table(curve);
  Rows rows;
  for (const UnfittedCurve& curve : result.unfitted) rows.push_back({curve.file, curve.reason});
  if (!rows.empty()) text += heading(2, "Not fitted") + html::table({"curve", "why"}, rows, {0, 1});
  return text + "<p class=\"soft\">* the fit to quote.</p>\n";
}

std::string card(const Result& result) {
  const CardSummary& c = *result.card;
  Rows constants = {{"lattice constant", number(c.a0_A, "{:.6f}"), "Å"},
                    {"energy per atom", number(c.energy_per_atom_eV, "{:.5f}"), "eV"}};
  for (const auto& [name, value] : {std::pair{"C11", c.C11_eV_per_A2},
                                    {"C12", c.C12_eV_per_A2},
                                    {"C66", c.C66_eV_per_A2},
                                    {"sheet modulus E·h", c.Eh_eV_per_A2}})
    constants.push_back({name, in_N_per_m_text(value, "{:.2f}"), "N/m"});
  constants.push_back({"Poisson's ratio", number(c.nu, "{:.4f}"), ""});
  constants.push_back({"bending modulus", number(c.bending_modulus_eV, "{:.4f}"), "eV"});
  Rows curves;
  for (const StressCurve& s : result.stress_curves)
    curves.push_back({s.direction, in_N_per_m_text(s.secant_2_eV_per_A2, "{:.1f}"),
                      in_N_per_m_text(s.secant_5_eV_per_A2, "{:.1f}"), in_N_per_m_text(s.secant_10_eV_per_A2, "{:.1f}"),
                      in_N_per_m_text(s.strength_eV_per_A2, "{:.1f}") + (s.strength_is_artefact ? " (cut-off's)" : ""),
                      number(100 * s.strain_at_strength, "{:.1f}")});
  return heading(2, result.potential.name) + html::table({"of the flat sheet", "value", "unit"}, constants, {2}) +
         html::table({"direction", "secant at 2 % (N/m)", "at 5 %", "at 10 %", "strength (N/m)", "at strain (%)"},
                     curves) +
         folded("in words", card_table(result));
}

Row batch_row(const CaseOutcome& one, const Run& run) {
  const Result& r = *one.summary;
  const Fit *fit = closed_form_fit(run.fits), *quoted = recommended_fit(run.fits);
  const bool judged = r.agreement && r.agreement->load == run.load;
  const auto of = [](const Fit* f, double Fit::*value, double Fit::*error, int digits) {
    return f ? with_error_N_per_m(f->*value, f->*error, digits) : std::string("-");
  };
  return {std::filesystem::path(one.potential).stem().string(),
          fmt::format("{:g}", one.radius_A),
          r.card ? in_N_per_m_text(r.card->Eh_eV_per_A2, "{:.1f}") : "-",
          std::string(to_string(run.load)),
          of(fit, &Fit::Eh_eV_per_A2, &Fit::Eh_stderr_eV_per_A2, 1),
          of(quoted, &Fit::Eh_eV_per_A2, &Fit::Eh_stderr_eV_per_A2, 1),
          of(fit, &Fit::pretension_eV_per_A2, &Fit::pretension_stderr_eV_per_A2, 3),
          of(quoted, &Fit::pretension_eV_per_A2, &Fit::pretension_stderr_eV_per_A2, 3),
          judged ? number(100 * r.agreement->max_relative_difference, "{:.2f}") : "-",
          judged ? std::string(to_string(r.agreement->outcome)) : ""};
}

std::string batch(const Result& result) {
  Rows rows;
  for (const CaseOutcome& one : result.cases) {
    if (!one.summary) {
      rows.push_back({one.potential, fmt::format("{:g}", one.radius_A), "-", "-", "-", "-", "-", "-", "-",
                      fmt::format("failed, exit code {}", one.exit_code)});
      continue;
    }
    const bool atoms = std::ranges::any_of(one.summary->runs, &Run::is_atomistic);
    for (const Run& run : one.summary->runs)
      if (run.is_atomistic() || !atoms) rows.push_back(batch_row(one, run));
  }
  return html::table({"potential", "R (Å)", "card (N/m)", "load", "Eq. 16 E·h (N/m)", "quoted E·h (N/m)",
                      "Eq. 16 pretension (N/m)", "quoted pretension (N/m)", "largest difference (%)", "verdict"},
                     rows, {3, 9});
}

}  // namespace

std::string tables_of(const Result& result) {
  switch (result.command) {
    case Command::fit:
      return fits(result);
    case Command::potential:
      return card(result);
    case Command::batch:
      return batch(result);
    case Command::indentation:
    case Command::bulge:
    case Command::figure:
    case Command::verify:
    case Command::published:
    case Command::curve:
    case Command::design:
      return {};
  }
  return {};
}

}  // namespace validate
