// report.html: a run on one page that needs nothing else.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/result.hpp"

namespace compare {

/// A drawing for the page: SVG text as gnuplot wrote it.
struct ReportFigure {
  std::string svg, title, caption;
};

/// The page: verdict, headline table, figures, regimes and ratios, fits with intervals and warnings,
/// convergence per depth, provenance, how to make it again.
std::string report_html(const Result& result, const std::vector<ReportFigure>& figures);

/// Draws the figures anew (in a folder of its own that is removed) and writes the page. Without gnuplot the
/// page has no figures and says so. Throws Error (file failed).
void write_report(const Result& result, const std::filesystem::path& target);

/// The same as a document of a run folder.
void write_report_in(const Result& result, const std::filesystem::path& folder);

}  // namespace compare
