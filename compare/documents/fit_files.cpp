#include "compare/documents/fit_files.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <set>

#include "compare/base/file.hpp"
#include "compare/documents/bytes/run_h5.hpp"
#include "compare/documents/plots/draw.hpp"
#include "compare/documents/plots/many_plot.hpp"
#include "compare/documents/plots/measured_curve_plot.hpp"
#include "compare/documents/texts/json.hpp"
#include "compare/documents/texts/many_csv.hpp"
#include "compare/documents/texts/report_html.hpp"

namespace validate {
namespace {

/// Files of the same name in different folders get a number each.
std::string unique_name(const std::filesystem::path& file, std::set<std::string>& taken) {
  const std::string stem = "fit-" + file.stem().string();
  std::string name = stem;
  for (int i = 2; !taken.insert(name).second; ++i) name = fmt::format("{}-{}", stem, i);
  return name;
}

void write_many(const Result& result, const std::filesystem::path& folder) {
  std::string table = many_csv_header() + "\n";
  for (const CurveRow& row : result.many->rows) table += many_csv_row(row) + "\n";
  write_file(folder / "curves.csv", table);
  const auto plot = [&](const Plot& drawn, const char* name) {
    if (drawn.panels.empty()) return;
    if (const auto warning = write_plot(drawn, folder, name)) spdlog::warn("{}", *warning);
  };
  plot(many_map(*result.many), "map");
  plot(many_histograms(*result.many), "histograms");
  write_report(result, folder, folder / "report.html");
}

}  // namespace

void write_fit_files(const Result& result, const std::filesystem::path& folder) {
  write_file(folder / "fit.json", json_text(result));
  write_run_h5(result, folder / "run.h5");
  std::set<std::string> taken;
  for (const FittedCurve& curve : result.curves)
    if (const auto warning = write_plot(measured_plot(curve), folder, unique_name(curve.file, taken)))
      spdlog::warn("{}", *warning);
  if (result.many) write_many(result, folder);
}

}  // namespace validate
