// report.html: a run on one page that needs nothing else.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/results/result.hpp"

namespace validate {

/// A drawing for the page, as gnuplot wrote it: SVG text, or the bytes of a PNG where there are too many points. What
/// the page's script draws in its place is JSON: a chart, or the sheets in three dimensions (of one figure).
struct ReportFigure {
  std::string title, caption, content = {};
  bool png = false;
  std::string chart = {}, sheets = {};
};

/// The page: verdict, first figure, headline table, the other figures, regimes and ratios, fits with intervals and
/// warnings, convergence per depth, provenance, how to make it again.
std::string report_html(const Result& result, const std::vector<ReportFigure>& figures);

/// The page with its figures drawn anew (in a folder of its own that is removed); the atoms come from the run's folder.
/// Without gnuplot the page has only those that its
/// script draws, and says so. Throws Error (file failed).
std::string report_page(const Result& result, const std::filesystem::path& run_folder);

/// Writes it under a name of the program's own. Throws Error (file failed).
void write_report(const Result& result, const std::filesystem::path& run_folder, const std::filesystem::path& target);

}  // namespace validate
