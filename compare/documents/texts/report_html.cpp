#include "compare/documents/texts/report_html.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/documents/bytes/html.hpp"
#include "compare/documents/page/page.hpp"
#include "compare/documents/texts/json.hpp"
#include "compare/documents/texts/report_experiment.hpp"
#include "compare/documents/texts/report_tables.hpp"

namespace validate {
namespace {

constexpr const char* not_drawn =
    "<p class=\"static soft\">Not drawn: gnuplot is not installed; a browser with JavaScript draws it.</p>";

std::string drawing(const ReportFigure& figure, std::size_t index) {
  if (figure.content.empty()) return not_drawn;
  return "<div class=\"static\">" +
         (figure.png ? html::inline_png(figure.content, figure.title)
                     : html::inline_svg(figure.content, fmt::format("f{}-", index), figure.title)) +
         "</div>";
}

/// What is said of the sheets where they can be turned.
constexpr const char* caption_of_sheets =
    "<span class=\"live\">The sheet in three dimensions: drag, or use the arrow keys, to turn both; the slider goes "
    "through the computed depths. Positions are rounded to 0.004 Å. </span>";

std::string figure_html(const ReportFigure& figure, std::size_t index) {
  return fmt::format("<figure{}{}>\n{}\n<figcaption>{}{}</figcaption>\n</figure>\n",
                     figure.chart.empty() ? "" : fmt::format(" data-chart=\"{}\"", index),
                     figure.sheets.empty() ? "" : " data-sheets", drawing(figure, index),
                     figure.sheets.empty() ? "" : caption_of_sheets, html::escaped(figure.caption));
}

std::string figures_html(const std::vector<ReportFigure>& figures, std::size_t from = 0) {
  std::string text;
  for (std::size_t i = from; i < figures.size(); ++i) text += figure_html(figures[i], i);
  return text;
}

/// What the script draws: charts by the figure's number, and the sheets.
std::string data_of(const std::vector<ReportFigure>& figures) {
  std::string charts, sheets = "null";
  for (const ReportFigure& figure : figures) {
    charts += (charts.empty() ? "" : ",") + (figure.chart.empty() ? std::string("null") : figure.chart);
    if (!figure.sheets.empty()) sheets = figure.sheets;
  }
  return fmt::format("{{\"charts\":[{}],\"sheets\":{}}}", charts, sheets);
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
  text += fmt::format(
      "</dl>\n<p class=\"soft\">Everything at T = 0{}, without adhesion and without slip at the clamp.</p>\n",
      result.resolved.temperature_K > 0 ? " but what is said of the temperature asked for" : "");
  text += "<h2>How to make this again</h2>\n<pre>" + html::escaped(p.command_line) +
          "\nvalidate report run.h5    # this page, without computing</pre>\n";
  if (!result.is_experiment()) return text;
  text +=
      "<details><summary>the resolved case</summary>\n<pre>" +
      html::escaped(document(result.resolved).dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) +
      "</pre></details>\n";
  return text;
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
  if (!result.is_experiment())
    return page(fmt::format("validate {}", result.command),
                fmt::format("<h1>validate {}</h1>\n", result.command) + tables_of(result) + links(result) +
                    figures_html(figures) + provenance(result),
                data_of(figures));
  const std::string first = figures.empty() ? "<p class=\"soft\">No figures; the data are in curves.csv.</p>\n"
                                            : figure_html(figures.front(), 0);
  return page("validate: " + experiment_title(result),
              experiment_verdict(result) + first + experiment_tables(result) + figures_html(figures, 1) +
                  experiment_details(result) + provenance(result),
              data_of(figures));
}

}  // namespace validate
