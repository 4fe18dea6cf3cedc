#include "compare/documents/texts/ladder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "compare/documents/bytes/html.hpp"
#include "compare/documents/texts/numbers.hpp"
#include "compare/documents/texts/text_table.hpp"

namespace validate {
namespace {

std::string curve_in_words(const Run& run) {
  const std::string name = fmt::format("{} {}", to_string(run.model), to_string(run.load));
  return run.constants ? fmt::format("{} {}", name, to_string(*run.constants)) : name;
}

/// Cells of one fit: model, E·h, its interval, pretension, its interval, misfit, points.
std::array<std::string, 7> cells(const Fit& fit) {
  const auto interval = [](const std::array<double, 2>& ends, const char* format) {
    return number(in_N_per_m(ends[0]), format) + " … " + number(in_N_per_m(ends[1]), format);
  };
  return {model_in_words(fit.model) + (fit.recommended ? " *" : ""),
          number(in_N_per_m(fit.Eh_eV_per_A2), "{:.1f}"),
          interval(fit.Eh_interval_eV_per_A2, "{:.1f}"),
          number(in_N_per_m(fit.pretension_eV_per_A2), "{:.3f}"),
          interval(fit.pretension_interval_eV_per_A2, "{:.3f}"),
          number(100 * fit.rms_relative, "{:.2f}"),
          fmt::format("{}", fit.points)};
}

std::string truth(const Run& run) {
  return fmt::format("true: E·h {} N/m, pretension {} N/m", number(in_N_per_m(run.Eh_eV_per_A2), "{:.1f}"),
                     number(in_N_per_m(run.pretension_eV_per_A2), "{:.3f}"));
}

std::string bias_in_words(const FitBias& bias) {
  return fmt::format("Eq. 16 on a plain membrane of these constants reads E·h {:.1f} % too {} at these depths",
                     100 * std::abs(bias.Eh_read_eV_per_A2 / bias.Eh_true_eV_per_A2 - 1),
                     bias.Eh_read_eV_per_A2 > bias.Eh_true_eV_per_A2 ? "high" : "low");
}

double read_by_eq16(const Run& run) {
  const Fit* fit = closed_form_fit(run.fits);
  return fit ? fit->pretension_eV_per_A2 - run.pretension_eV_per_A2 : not_known;
}

}  // namespace

std::vector<std::string> ladder_sentences(const Result& result) {
  std::vector<std::string> all;
  for (const Run& run : result.runs) {
    if (!run.is_atomistic()) continue;
    if (const Fit* eq16 = closed_form_fit(run.fits); eq16 && eq16->bias)
      all.push_back(fmt::format("{} load: {}.", to_string(run.load), bias_in_words(*eq16->bias)));
    if (const auto parts = pretension_parts(result, run.load)) all.push_back(in_words(*parts, run.load));
  }
  return all;
}

std::string model_in_words(const std::string& model) {
  if (model == "eq16") return "Eq. 16";
  if (model == fitted_membrane) return "membrane itself";
  if (model == fitted_third_order) return "third-order law";
  if (model == fitted_sheet) return "own law, bending";
  return model;
}

std::optional<PretensionParts> pretension_parts(const Result& result, LoadKind load) {
  const auto find = [&](auto&& wanted) -> const Run* {
    const auto found = std::ranges::find_if(
        result.runs, [&](const Run& run) { return run.load == load && wanted(run) && closed_form_fit(run.fits); });
    return found == result.runs.end() ? nullptr : &*found;
  };
  const Run* atoms = find([](const Run& run) { return run.is_atomistic(); });
  const Run* plain =
      find([](const Run& run) { return run.model == Model::membrane && run.constants == Constants::card; });
  const Run* soft =
      find([](const Run& run) { return run.model == Model::membrane && run.constants == Constants::calibrated; });
  const Run* sheet =
      find([](const Run& run) { return run.model == Model::sheet && run.constants == Constants::calibrated; });
  if (!atoms || !plain || !soft || !sheet) return std::nullopt;
  const double a = read_by_eq16(*atoms), p = read_by_eq16(*plain), s = read_by_eq16(*soft), b = read_by_eq16(*sheet);
  return PretensionParts{p, s - p, b - s, a - b, a};
}

std::string in_words(const PretensionParts& parts, LoadKind load) {
  return fmt::format(
      "{} load: of the {:.3f} N/m that Eq. 16 reads as pretension and nobody imposed, {:+.3f} is its form and the tip, "
      "{:+.3f} the softening of the bonds, {:+.3f} bending and {:+.3f} the rest.",
      to_string(load), in_N_per_m(parts.total), in_N_per_m(parts.form), in_N_per_m(parts.softening),
      in_N_per_m(parts.bending), in_N_per_m(parts.rest));
}

std::string ladder_text(const Result& result, int width) {
  TextTable table({{.heading = "What each model reads", .align = Align::left},
                   {.heading = "E·h", .unit = "N/m"},
                   {.heading = "95 %", .unit = "N/m"},
                   {.heading = "pretension", .unit = "N/m"},
                   {.heading = "95 %", .unit = "N/m"},
                   {.heading = "misfit", .unit = "%", .rank = 1},
                   {.heading = "points", .rank = 2}},
                  2);
  for (const Run& run : result.runs) {
    if (run.fits.empty()) continue;
    table.add_line(fmt::format("{} ({})", curve_in_words(run), truth(run)));
    for (const Fit& fit : run.fits) {
      const auto c = cells(fit);
      table.add({c.begin(), c.end()});
    }
  }
  return table.text(width) + '\n';
}

std::string ladder_html(const Result& result) {
  std::string text = "<h2>What each model reads: E·h and pretension (N/m)</h2>\n";
  for (const Run& run : result.runs) {
    if (run.fits.empty()) {
      text += "<p>" + html::escaped(curve_in_words(run)) + ": no fit: " + html::escaped(run.fit_skipped) + "</p>\n";
      continue;
    }
    std::vector<std::vector<std::string>> rows;
    for (const Fit& fit : run.fits) {
      const auto c = cells(fit);
      rows.emplace_back(c.begin(), c.end());
    }
    text += "<h3>" + html::escaped(curve_in_words(run)) + "</h3>\n<p class=\"soft\">" + html::escaped(truth(run)) +
            "</p>\n" + html::table({"model", "E·h", "95 %", "pretension", "95 %", "misfit %", "points"}, rows);
  }
  for (const std::string& sentence : ladder_sentences(result)) text += "<p>" + html::escaped(sentence) + "</p>\n";
  return text +
         "<p class=\"soft\">All models of a curve are fitted at the same depths. The curves are computed: intervals "
         "are "
         "those of the numerical errors and of the clamp radius, the misfit is none. True: the constants of the "
         "continuum, or of the potential at small strains. * the fit to quote.</p>\n";
}

}  // namespace validate
