#include "compare/documents/texts/report_html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "compare/base/units.hpp"
#include "compare/documents/bytes/html.hpp"
#include "compare/documents/plots/explanation_bars.hpp"
#include "compare/documents/texts/batch_table.hpp"
#include "compare/documents/texts/card_files.hpp"
#include "compare/documents/texts/json.hpp"
#include "compare/documents/texts/measured_report.hpp"
#include "compare/documents/texts/pressed_table.hpp"

namespace validate {
namespace {

using Rows = std::vector<std::vector<std::string>>;

double in_N_per_m(double eV_per_A2) { return eV_per_A2 * N_per_m_per_eV_per_A2; }

/// A rounding error of either sign is 0, not -0.
std::string number(double value, const char* format) {
  if (!std::isfinite(value)) return "–";
  const std::string text = fmt::format(fmt::runtime(format), value);
  const bool zero = text.find_first_not_of("-0.") == std::string::npos;
  return zero ? fmt::format(fmt::runtime(format), 0.0) : text;
}

std::string name_of(const Run& run) {
  const std::string name =
      fmt::format("{}, {}", run.model == Model::atomistic ? "atoms" : to_string(run.model), to_string(run.load));
  if (!run.constants) return name;
  return fmt::format("{}, {} {}", name, to_string(*run.constants),
                     run.constants == Constants::calibrated ? "law" : "constants");
}

std::string pair_N_per_m(double value, double error, int digits) {
  const char* const format = digits == 1 ? "{:.1f}" : "{:.3f}";
  return number(in_N_per_m(value), format) + " ± " + number(in_N_per_m(error), format);
}

std::string interval_N_per_m(const std::array<double, 2>& ends, int digits) {
  if (!std::isfinite(ends[0]) || !std::isfinite(ends[1])) return "–";
  return fmt::format("{:.{}f} … {:.{}f}", in_N_per_m(ends[0]), digits, in_N_per_m(ends[1]), digits);
}

std::string verdict(const Result& result) {
  if (!result.agreement)
    return fmt::format(
        "<p class=\"verdict\"><b>No verdict</b>: {}.</p>\n",
        html::escaped(result.agreement_skipped.empty() ? "nothing to compare" : result.agreement_skipped));
  const Agreement& a = *result.agreement;
  return fmt::format(
      "<p class=\"verdict {}\"><b>{}</b>: over depth/a from {:.2f} to {:.2f} of the {} load the atoms' force "
      "differs from "
      "{} by at most {:.2f} % (tolerance {:.2f} %).</p>\n",
      a.outcome == Outcome::agree ? "good" : "bad", a.outcome == Outcome::agree ? "Agreement" : "Disagreement",
      a.window[0], a.window[1], to_string(a.load),
      a.against == Model::sheet
          ? "that of the sheet that the potential's own law makes, with bending and no fitted number,"
          : "the like-for-like membrane's",
      100 * a.max_relative_difference, 100 * a.tolerance);
}

std::string heading(const Result& result) {
  std::string text = fmt::format("<h1>{}, R = {:g} Å</h1>\n",
                                 html::escaped(result.card || result.sheet ? result.resolved.potential : "membrane"),
                                 result.resolved.radius_A);
  if (const auto& card = result.card)
    text += fmt::format(
        "<p class=\"soft\">Potential card: a<sub>0</sub> = {:.5f} Å, E·h = {:.1f} N/m ({:.3f} eV/Å²), ν = "
        "{:.4f}, "
        "κ = {:.3f} eV.{}</p>\n",
        card->a0_A, in_N_per_m(card->Eh_eV_per_A2), card->Eh_eV_per_A2, card->nu, card->bending_modulus_eV,
        result.sheet ? fmt::format(" {} atoms, effective radius a = {:.3f} Å.", result.sheet->atoms,
                                   result.sheet->effective_radius_A)
                     : "");
  return text;
}

std::string known_bias(const FitBias& bias) {
  return fmt::format("{:+.1f} %", 100 * (bias.Eh_read_eV_per_A2 / bias.Eh_true_eV_per_A2 - 1));
}

/// Two tables, so that each fits a phone and a page.
std::string headline_tables(const Result& result) {
  Rows moduli, pretensions;
  for (const Run& run : result.runs) {
    const std::string modulus = number(in_N_per_m(run.Eh_eV_per_A2), "{:.1f}");
    const std::string pretension = number(in_N_per_m(run.pretension_eV_per_A2), "{:.3f}");
    const Fit* found = closed_form_fit(run.fits);
    if (!found) {
      moduli.push_back({name_of(run), modulus, "no fit", "–", "–", "–"});
      pretensions.push_back({name_of(run), pretension, "no fit", "–", "–", "–"});
      continue;
    }
    const Fit& fit = *found;
    const auto& bias = fit.bias;
    const Fit* direct = continuum_fit(run.fits);
    moduli.push_back({name_of(run), modulus, pair_N_per_m(fit.Eh_eV_per_A2, fit.Eh_stderr_eV_per_A2, 1),
                      bias ? known_bias(*bias) : "–",
                      bias ? number(in_N_per_m(bias->Eh_corrected_eV_per_A2), "{:.1f}") : "–",
                      direct ? pair_N_per_m(direct->Eh_eV_per_A2, direct->Eh_stderr_eV_per_A2, 1) : "–"});
    pretensions.push_back(
        {name_of(run), pretension, pair_N_per_m(fit.pretension_eV_per_A2, fit.pretension_stderr_eV_per_A2, 3),
         bias ? fmt::format("{:+.3f}", in_N_per_m(bias->pretension_read_eV_per_A2 - bias->pretension_true_eV_per_A2))
              : "–",
         bias ? number(in_N_per_m(bias->pretension_corrected_eV_per_A2), "{:.3f}") : "–",
         direct ? pair_N_per_m(direct->pretension_eV_per_A2, direct->pretension_stderr_eV_per_A2, 3) : "–"});
  }
  const auto header = [](const char* what) {
    return std::vector<std::string>{what, "true", "Eq. 16", "its bias", "corrected", "membrane itself"};
  };
  std::string skipped;
  for (const Run& run : result.runs)
    if (run.fits.empty())
      skipped += "<p>" + html::escaped(name_of(run)) + ": no fit: " + html::escaped(run.fit_skipped) + "</p>\n";
  return "<h2>E·h and pretension (N/m)</h2>\n" + html::table(header("E·h"), moduli) +
         html::table(header("pretension"), pretensions) + skipped +
         "<p class=\"soft\">True: the constants of the membrane, or of the potential from small strains. Its "
         "bias: what Eq. 16 "
         "reads from the like-for-like membrane over the same depths, whose constants are known. Membrane "
         "itself: the "
         "finite-strain membrane with the real tip, E·h and pretension free. Errors are standard errors of "
         "the fit and know "
         "nothing of the bias. What is left between the membrane itself and true, for atoms, is what the "
         "membrane lacks: bending, "
         "which reads as pretension, and the softening of the bonds.</p>\n";
}

std::string drawing(const ReportFigure& figure, std::size_t index) {
  return figure.png ? html::inline_png(figure.content, figure.title)
                    : html::inline_svg(figure.content, fmt::format("f{}-", index), figure.title);
}

std::string figures_html(const std::vector<ReportFigure>& figures) {
  if (figures.empty())
    return "<p class=\"soft\">No figures: gnuplot is not installed; the data are in curves.csv.</p>\n";
  std::string text;
  for (std::size_t i = 0; i < figures.size(); ++i)
    text += fmt::format("<figure>\n{}\n<figcaption>{}</figcaption>\n</figure>\n", drawing(figures[i], i),
                        html::escaped(figures[i].caption));
  return text;
}

std::string regimes(const Comparison& c, double tolerance) {
  std::string text;
  if (std::isfinite(c.bending_to_A))
    text += fmt::format("Bending keeps the atoms more than {:g} % above the membrane up to a depth of {:.3g} Å. ",
                        100 * tolerance, c.bending_to_A);
  if (std::isfinite(c.softening_from_A))
    text += fmt::format("Softening of the bonds takes them more than {:g} % below it from {:.3g} Å on. ",
                        100 * tolerance, c.softening_from_A);
  if (std::isfinite(c.artefact_from_A))
    text += fmt::format("From {:.3g} Å on the forces are an artefact of the potential. ", c.artefact_from_A);
  if (std::isfinite(c.predicted_artefact_from_A))
    text += fmt::format("The calibrated sheet's strains put the artefact's beginning at {:.3g} Å. ",
                        c.predicted_artefact_from_A);
  return text.empty() ? "One regime throughout." : text;
}

std::string explanation(const Result& result, LoadKind load) {
  for (const Explanation& e : result.explanations) {
    if (e.load != load) continue;
    std::vector<std::string> header = {"depth / a"};
    for (const Share& share : shares()) header.emplace_back(share.name);
    Rows rows;
    for (const std::size_t i : shown_depths(e.depth_A.size())) {
      std::vector<std::string> row = {number(e.depth_relative[i], "{:.4f}")};
      for (const Share& share : shares()) row.push_back(number(100 * (e.*share.values)[i], "{:+.2f} %"));
      rows.push_back(std::move(row));
    }
    return "<h4>What a plain membrane lacks</h4>\n" + html::table(header, rows);
  }
  return {};
}

std::string comparisons(const Result& result) {
  if (result.comparisons.empty()) return {};
  std::string text = "<h2>Where continuum and atoms part</h2>\n";
  for (const Comparison& c : result.comparisons) {
    text +=
        fmt::format("<h3>{} load</h3>\n<p>{}</p>\n", to_string(c.load), regimes(c, result.resolved.regime_tolerance));
    Rows rows;
    for (std::size_t i = 0; i < c.depth_A.size(); ++i)
      rows.push_back({number(c.depth_A[i], "{:.3f}"), number(c.depth_relative[i], "{:.4f}"),
                      number(c.force_ratio[i], "{:.4f}"), number(c.depth_ratio[i], "{:.4f}"),
                      number(c.energy_ratio[i], "{:.4f}"), number(c.calibrated_membrane_ratio[i], "{:.4f}"),
                      number(c.sheet_ratio[i], "{:.4f}"), std::string(to_string(c.regime[i]))});
    text += html::table({"depth (Å)", "depth / a", "force ratio", "depth ratio", "energy ratio", "calibrated membrane",
                         "calibrated sheet", "regime"},
                        rows);
    text += explanation(result, c.load);
  }
  return text +
         "<p class=\"soft\">Ratios are atoms / membrane with the potential's own constants: force and energy "
         "at equal depth, "
         "depth at equal force; force over that of the membrane and of the bending sheet with the potential's own law. "
         "What "
         "a plain membrane (nominal radii, St Venant–Kirchhoff) lacks is in per cent of its force.</p>\n";
}

std::string fits(const Result& result) {
  Rows rows;
  std::string warnings;
  for (const Run& run : result.runs) {
    const Fit* found = closed_form_fit(run.fits);
    if (!found) continue;
    const Fit& fit = *found;
    rows.push_back({name_of(run), interval_N_per_m(fit.Eh_interval_eV_per_A2, 1),
                    number(in_N_per_m(fit.Eh_bootstrap_eV_per_A2), "{:.2f}"),
                    interval_N_per_m(fit.pretension_interval_eV_per_A2, 3),
                    number(in_N_per_m(fit.pretension_bootstrap_eV_per_A2), "{:.3f}"), number(fit.correlation, "{:.3f}"),
                    number(fit.condition_number, "{:.1f}"), number(fit.r_squared, "{:.6f}"),
                    number(100 * fit.rms_relative, "{:.3f}"), fmt::format("{}", fit.points),
                    fmt::format("{:.3g} … {:.3g}", fit.window_A[0], fit.window_A[1])});
    for (const std::string& warning : fit.warnings)
      warnings += "<li>" + html::escaped(name_of(run)) + ": " + html::escaped(warning) + "</li>\n";
  }
  if (rows.empty()) return {};
  std::string text = "<h2>How far to trust the fits</h2>\n" +
                     html::table({"Eq. 16 fitted to", "E·h 95 %", "bootstrap ±", "pretension 95 %", "bootstrap ±",
                                  "correlation", "condition", "R²", "rms %", "points", "depths (Å)"},
                                 rows);
  if (!warnings.empty()) text += "<ul>\n" + warnings + "</ul>\n";
  return text;
}

/// What the softness of a sphere's contact does to its curve.
std::string contact(const Run& run) {
  if (!run.is_atomistic() || !run.atoms().contact) return {};
  const ContactSensitivity& c = *run.atoms().contact;
  return fmt::format(
      "<p>{}: atoms are up to {:.3f} Å inside the sphere. A contact four times stiffer changes the last depth's force "
      "by "
      "{:.2f} % at equal travel and by {:.2f} % at equal depth of the sheet.</p>\n",
      html::escaped(name_of(run)), c.deepest_penetration_A, 100 * c.force_change_relative,
      100 * c.force_change_at_equal_depth_relative);
}

std::string quality(const Result& result) {
  std::string text = "<h2>Convergence and quality, depth by depth</h2>\n";
  for (const Run& run : result.runs) {
    const bool atoms = run.model == Model::atomistic;
    Rows rows;
    for (std::size_t i = 0; i < run.depth_A.size(); ++i) {
      std::vector<std::string> row = {number(run.depth_A[i], "{:.3f}"), number(run.force_eV_per_A[i], "{:.5f}"),
                                      number(run.energy_eV[i], "{:.4f}"), run.converged[i] ? "yes" : "no"};
      if (atoms) {
        const AtomsPart& part = run.atoms();
        const std::vector<std::string> more = {
            number(run.longest_bond_A[i], "{:.4f}"),      number(part.max_force_eV_per_A[i], "{:.1e}"),
            number(part.balance_relative[i], "{:.1e}"),   number(part.force_error_relative[i], "{:.1e}"),
            fmt::format("{}", part.force_evaluations[i]), fmt::format("{}", part.factorisations[i])};
        row.insert(row.end(), more.begin(), more.end());
      } else {
        row.push_back(fmt::format("{}", run.continuum().newton_iterations[i]));
      }
      rows.push_back(std::move(row));
    }
    std::vector<std::string> header = {"depth (Å)", "force (eV/Å)", "energy (eV)", "converged"};
    const std::vector<std::string> more =
        atoms ? std::vector<std::string>{"longest bond (Å)", "max |f| (eV/Å)", "balance",
                                         "force error",      "evaluations",    "factors"}
              : std::vector<std::string>{"Newton steps"};
    header.insert(header.end(), more.begin(), more.end());
    text += fmt::format("<details><summary>{}: {} depths, ended: {}{}</summary>\n", html::escaped(name_of(run)),
                        run.depth_A.size(), to_string(run.ended),
                        run.ended_reason.empty() ? "" : " (" + html::escaped(run.ended_reason) + ")") +
            html::table(header, rows) + "</details>\n" + contact(run);
  }
  return text;
}

std::string provenance(const Result& result) {
  const Provenance& p = result.provenance;
  std::string text = "<h2>Provenance</h2>\n<dl>\n";
  const auto add = [&](const char* what, const std::string& value) {
    if (!value.empty()) text += fmt::format("<dt>{}</dt><dd>{}</dd>\n", what, html::escaped(value));
  };
  add("validate", p.version + (p.git.empty() ? "" : ", revision " + p.git));
  add("LAMMPS", p.lammps);
  add("GSL", p.gsl);
  add("HDF5", p.hdf5);
  add("SuiteSparse", p.suitesparse);
  add("BLAS", p.blas);
  add("potential file", p.potential_file);
  add("SHA-256", p.potential_sha256);
  if (std::isfinite(result.timing.wall_s)) add("wall time", fmt::format("{:.1f} s", result.timing.wall_s));
  text += "</dl>\n<p class=\"soft\">Everything at T = 0, without adhesion and without slip at the clamp.</p>\n";
  text += "<h2>How to make this again</h2>\n<pre>" + html::escaped(p.command_line) +
          "\nvalidate report run.h5    # this page, without computing</pre>\n";
  if (!result.is_experiment()) return text;
  text +=
      "<details><summary>the resolved case</summary>\n<pre>" +
      html::escaped(document(result.resolved).dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) +
      "</pre></details>\n";
  return text;
}

}  // namespace

namespace {

std::string preformatted(const std::string& text) { return "<pre>" + html::escaped(text) + "</pre>\n"; }

/// What the terminal shows of a command that is no experiment.
std::string shown_on_terminal(const Result& result) {
  std::string text;
  switch (result.command) {
    case Command::fit:
      for (const FittedCurve& curve : result.curves) text += measured_text(curve) + "\n";
      return text;
    case Command::potential:
      return card_table(result);
    case Command::batch:
      return batch_table(result);
    case Command::indentation:
    case Command::bulge:
    case Command::figure:
    case Command::verify:
      return {};
  }
  return {};
}

/// The cases' own pages, beside the batch's.
std::string links(const Result& batch) {
  std::string text;
  for (const CaseOutcome& one : batch.cases)
    text += fmt::format("<li><a href=\"{0}/report.html\">{0}</a>: exit code {1}</li>\n", html::escaped(one.folder),
                        one.exit_code);
  return text.empty() ? text : "<ul>\n" + text + "</ul>\n";
}

std::string experiment_body(const Result& result, const std::vector<ReportFigure>& figures) {
  const std::string pressed = pressed_table(result);
  const bool indented = result.runs.empty() ||
                        std::ranges::any_of(result.runs, [](const Run& run) { return run.load != LoadKind::pressure; });
  return heading(result) + (indented ? verdict(result) + headline_tables(result) : std::string()) +
         (pressed.empty() ? pressed : preformatted(pressed)) + figures_html(figures) + comparisons(result) +
         fits(result) + quality(result) + provenance(result);
}

}  // namespace

std::string report_html(const Result& result, const std::vector<ReportFigure>& figures) {
  if (result.is_experiment())
    return html::page(fmt::format("validate: {}, R = {:g} Å", result.resolved.potential, result.resolved.radius_A),
                      experiment_body(result, figures));
  return html::page(fmt::format("validate {}", result.command),
                    fmt::format("<h1>validate {}</h1>\n", result.command) + preformatted(shown_on_terminal(result)) +
                        links(result) + (figures.empty() ? std::string() : figures_html(figures)) + provenance(result));
}

}  // namespace validate
