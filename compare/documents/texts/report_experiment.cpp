#include "compare/documents/texts/report_experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/documents/bytes/html.hpp"
#include "compare/documents/plots/explanation_bars.hpp"
#include "compare/documents/sentences/shown_units.hpp"
#include "compare/documents/texts/breaking_text.hpp"
#include "compare/documents/texts/ladder.hpp"
#include "compare/documents/texts/numbers.hpp"
#include "compare/documents/texts/pulled_rim_table.hpp"
#include "compare/documents/texts/regime_text.hpp"
#include "compare/documents/texts/report_tables.hpp"
#include "compare/results/pulled_rim.hpp"

namespace validate {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string name_of(const Run& run) {
  if (has_pulled_rim(run)) return pulled_curve_in_words(run);
  const std::string name =
      fmt::format("{}, {}", run.model == Model::atomistic ? "atoms" : to_string(run.model), to_string(run.load));
  if (!run.constants) return name;
  return fmt::format("{}, {} {}", name, to_string(*run.constants),
                     run.constants == Constants::calibrated ? "law" : "constants");
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
      "{} by at most {:.2f} %, uncertain by up to ± {:.2f} % (95 %); the tolerance is {:.2f} %.</p>\n",
      a.outcome == Outcome::agree ? "good" : "bad",
      a.outcome == Outcome::agree      ? "Agreement"
      : a.outcome == Outcome::disagree ? "Disagreement"
                                       : "Undecided",
      a.window[0], a.window[1], to_string(a.load),
      a.against == Model::sheet
          ? "that of the sheet that the potential's own law makes, with bending and no fitted number,"
          : "the like-for-like membrane's",
      100 * a.max_relative_difference, 100 * a.expanded_uncertainty, 100 * a.tolerance);
}

std::string heading(const Result& result) {
  std::string text = "<h1>" + html::escaped(experiment_title(result)) + "</h1>\n";
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

std::string regimes(const Comparison& c, bool explained) {
  std::string text = fmt::format("{} ({}). ", regime_text(c),
                                 explained ? "what a plain membrane lacks most of" : "by the force ratio alone");
  if (std::isfinite(c.artefact_from_A))
    text += fmt::format("From {:.3g} Å on the forces are an artefact of the potential. ", c.artefact_from_A);
  if (std::isfinite(c.predicted_artefact_from_A))
    text += fmt::format("The calibrated sheet's strains put the artefact's beginning at {:.3g} Å. ",
                        c.predicted_artefact_from_A);
  return text;
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
  for (const std::string& one : breaking_sentences(result)) text += "<p>" + html::escaped(one) + "</p>\n";
  for (const Comparison& c : result.comparisons) {
    const bool explained =
        std::ranges::find(result.explanations, c.load, &Explanation::load) != result.explanations.end();
    text += fmt::format("<h3>{} load</h3>\n<p>{}</p>\n", to_string(c.load), regimes(c, explained));
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
  std::string warnings;
  for (const Run& run : result.runs)
    for (const Fit& fit : run.fits)
      for (const std::string& warning : fit.warnings)
        warnings +=
            "<li>" + html::escaped(name_of(run) + ", " + model_in_words(fit.model) + ": " + warning) + "</li>\n";
  if (warnings.empty()) return {};
  return "<h2>How far to trust the fits</h2>\n<ul>\n" + warnings + "</ul>\n";
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

/// The numbers that tell of a level's convergence, atoms' or a continuum's.
std::string levels_table(const Run& run) {
  std::vector<std::string> header = {"depth (Å)", "force (eV/Å)", "energy (eV)", "converged"};
  if (run.is_atomistic())
    for (const char* name :
         {"longest bond (Å)", "max |f| (eV/Å)", "balance", "force error", "evaluations", "set-ups", "solves"})
      header.emplace_back(name);
  else
    header.emplace_back("Newton steps");
  Rows rows;
  for (std::size_t i = 0; i < run.depth_A.size(); ++i) {
    std::vector<std::string>& row = rows.emplace_back();
    row = {number(run.depth_A[i], "{:.3f}"), number(run.force_eV_per_A[i], "{:.5f}"),
           number(run.energy_eV[i], "{:.4f}"), run.converged[i] ? "yes" : "no"};
    if (!run.is_atomistic()) {
      row.push_back(std::to_string(run.continuum().newton_iterations[i]));
      continue;
    }
    const AtomsPart& part = run.atoms();
    row.push_back(number(run.longest_bond_A[i], "{:.4f}"));
    for (const auto* column : {&part.max_force_eV_per_A, &part.balance_relative, &part.force_error_relative})
      row.push_back(number((*column)[i], "{:.1e}"));
    for (const auto* column : {&part.force_evaluations, &part.factorisations, &part.solves})
      row.push_back(std::to_string((*column)[i]));
  }
  return html::table(header, rows);
}

std::string quality(const Result& result) {
  std::string text = "<h2>Convergence and quality, depth by depth</h2>\n";
  for (const Run& run : result.runs)
    text += fmt::format("<details><summary>{}: {} depths, ended: {}{}</summary>\n", html::escaped(name_of(run)),
                        run.depth_A.size(), to_string(run.ended),
                        run.ended_reason.empty() ? "" : " (" + html::escaped(run.ended_reason) + ")") +
            levels_table(run) + "</details>\n" + contact(run);
  return text;
}

/// Whether anything but a pressure acted, or nothing at all.
bool is_indented(const Result& result) {
  return result.runs.empty() ||
         std::ranges::any_of(result.runs, [](const Run& run) { return run.load != LoadKind::pressure; });
}

}  // namespace

std::string experiment_title(const Result& result) {
  std::string size = shown_units(result.resolved).length.text(result.resolved.radius_A);
  if (const auto blank = size.find(' '); blank != std::string::npos) size.replace(blank, 1, "\u00a0");
  return fmt::format("{}, R = {}", result.card || result.sheet ? result.resolved.potential : "membrane", size);
}

std::string experiment_verdict(const Result& result) {
  return heading(result) +
         (is_indented(result) && !(has_pulled_rim(result) && !result.sheet) ? verdict(result) : std::string());
}

std::string experiment_tables(const Result& result) {
  if (const std::string pulled = pulled_rim_table(result); !pulled.empty()) return html::preformatted(pulled);
  return (is_indented(result) ? ladder_html(result) : std::string()) + pressed_tables(result);
}

std::string experiment_details(const Result& result) { return comparisons(result) + fits(result) + quality(result); }

}  // namespace validate
