#include "compare/documents/texts/report_html.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/documents/bytes/html.hpp"
#include "compare/documents/texts/batch_table.hpp"
#include "compare/documents/texts/card_files.hpp"
#include "compare/documents/texts/json.hpp"
#include "compare/documents/texts/measured_report.hpp"
#include "compare/documents/texts/published_table.hpp"
#include "compare/documents/texts/report_experiment.hpp"

namespace validate {
namespace {

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
    case Command::published:
      return published_text(result.beside);
    case Command::curve:
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

}  // namespace

std::string report_html(const Result& result, const std::vector<ReportFigure>& figures) {
  if (result.is_experiment())
    return html::page(
        fmt::format("validate: {}, R = {:g} Å", result.resolved.potential, result.resolved.radius_A),
        experiment_summary(result) + figures_html(figures) + experiment_details(result) + provenance(result));
  return html::page(fmt::format("validate {}", result.command),
                    fmt::format("<h1>validate {}</h1>\n", result.command) +
                        html::preformatted(shown_on_terminal(result)) + links(result) +
                        (figures.empty() ? std::string() : figures_html(figures)) + provenance(result));
}

}  // namespace validate
