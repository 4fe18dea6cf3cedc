// What the page of a run shows, drawn.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "compare/base/file.hpp"
#include "compare/base/read_file.hpp"
#include "compare/base/temporary_folder.hpp"
#include "compare/documents/bytes/extxyz.hpp"
#include "compare/documents/bytes/trajectory_h5.hpp"
#include "compare/documents/page/plot_json.hpp"
#include "compare/documents/page/sheets_json.hpp"
#include "compare/documents/plots/draw.hpp"
#include "compare/documents/plots/explanation_bars.hpp"
#include "compare/documents/plots/force_depth.hpp"
#include "compare/documents/plots/from_above.hpp"
#include "compare/documents/plots/many_plot.hpp"
#include "compare/documents/plots/measured_curve_plot.hpp"
#include "compare/documents/plots/pressed_atoms_plot.hpp"
#include "compare/documents/plots/pulled_rim_plot.hpp"
#include "compare/documents/plots/ratio.hpp"
#include "compare/documents/plots/sheet_maps.hpp"
#include "compare/documents/plots/stress_strain.hpp"
#include "compare/documents/plots/thermal_plot.hpp"
#include "compare/documents/plots/window_scan.hpp"
#include "compare/documents/texts/report_html.hpp"
#include "compare/results/pulled_rim.hpp"

namespace validate {
namespace {

struct Drawing {
  ReportFigure figure;  ///< its content is drawn
  Plot plot;
};

/// The membrane beside the atoms: like for like under the judged load, or the given one.
const Run* shown_membrane(const Result& result) {
  const auto found = std::ranges::find_if(result.runs, [&](const Run& run) {
    return run.model == Model::membrane &&
           (run.constants == Constants::given ||
            (run.constants == Constants::card && run.load == result.resolved.judged_load));
  });
  return found == result.runs.end() ? nullptr : &*found;
}

/// The atoms come from the run's folder.
Plot sheets_from_above(const Result& result, const std::filesystem::path& run_folder) {
  const LoadKind load = result.resolved.judged_load;
  return from_above_plot(load, read_free_atoms(run_folder / fmt::format("atoms-{}.extxyz", load)),
                         shown_membrane(result));
}

std::vector<Drawing> experiment_drawings(const Result& result, const std::filesystem::path& run_folder) {
  return {
      {{.title = "force against depth",
        .caption =
            "Force against depth: atoms as markers (open in the artefact zone), the calibrated sheet as thick lines, "
            "membranes thin (dashed: the paper's constants), Eq. 16 black."},
       force_depth_plot(result)},
      {{.title = "the sheet from above",
        .caption = "The deepest sheet from above: the atoms' longest bonds, and the membrane's larger principal Cauchy "
                   "force (stress times thickness) under the same load.",
        .png = true},
       sheets_from_above(result, run_folder)},
      {{.title = "atoms over membrane",
        .caption = "The atoms' force over that of each continuum at equal depth (open: artefact zone). Green: the "
                   "tolerance; dotted: the judged window."},
       ratio_plot(result)},
      {{.title = "what a plain membrane lacks",
        .caption = "From a plain membrane (the paper's law with the card's constants, nominal radii) to the atoms, in "
                   "per cent of its force at the same depth: bars add up to the atoms' (squares)."},
       explanation_plot(result)},
      {{.title = "fits against the window",
        .caption = "Eq. 16 fitted up to increasing depths. Dashed: the constants of the curve. A result "
                   "that moves with "
                   "the window is not one number."},
       window_scan_plot(result)},
      {{.title = "at the temperature",
        .caption =
            "The atoms' force at T = 0 and at the temperature, and by how much deeper the same force presses: by "
            "the vibrations about the equilibria, and by dynamics with its 95 %."},
       thermal_plot(result)}};
}

/// A sheet of triangles under a pressure at its last level, and the atoms beside it.
std::vector<Drawing> pressed_drawings(const Result& result) {
  std::vector<Drawing> drawings;
  for (const Run& run : result.runs)
    if (run.load == LoadKind::pressure && run.model == Model::membrane && run.continuum().pictures &&
        !run.continuum().pictures->empty())
      drawings.push_back({{.title = "the membrane from above",
                           .caption = "Principal Cauchy stresses and states of the membrane under the last pressure.",
                           .png = true},
                          sheet_plot(run.continuum().pictures->back())});
  drawings.push_back({{.title = "atoms beside the membrane",
                       .caption = "Depth against pressure, and both cross-sections under the last one."},
                      pressed_atoms_plot(result)});
  return drawings;
}

std::vector<Drawing> pulled_drawings(const Result& result) {
  return {
      {{.title = "force and wrinkles",
        .caption = "Above: force over 2πTδ, what a sheet that is wrinkled all over bears under a point, against depth "
                   "over radius. Below: the share of the area that is wrinkled (tension field) or compressed."},
       pulled_rim_plot(result)}};
}

std::vector<Drawing> drawings(const Result& result, const std::filesystem::path& run_folder) {
  std::vector<Drawing> all;
  switch (result.command) {
    case Command::indentation:
    case Command::bulge:
      if (has_pulled_rim(result)) return pulled_drawings(result);
      all = pressed_drawings(result);
      if (result.resolved.loads != std::vector<LoadKind>{LoadKind::pressure})
        for (Drawing& drawing : experiment_drawings(result, run_folder)) all.push_back(std::move(drawing));
      return all;
    case Command::fit:
      if (result.many) {
        all.push_back({{.title = "map", .caption = "E·h, pretension and height of the contact over the map."},
                       many_map(*result.many)});
        all.push_back(
            {{.title = "histograms",
              .caption = "Line: the mean; grey: what one curve is expected in by spread and noise; dashed: one "
                         "E·h for all curves."},
             many_histograms(*result.many)});
      }
      for (const FittedCurve& curve : result.curves)
        all.push_back({{.title = curve.file, .caption = curve.file}, measured_plot(curve)});
      return all;
    case Command::potential:
      return {{{.title = "stress and strain", .caption = "Homogeneous strain at T = 0."}, stress_strain_plot(result)}};
    case Command::figure:
    case Command::verify:
    case Command::batch:
    case Command::published:
    case Command::curve:
    case Command::design:
      return {};
  }
  return all;
}

/// The sheets in the place of the first picture of one; a figure of their own where there is none.
void add_sheets(std::vector<ReportFigure>& figures, std::string sheets) {
  if (sheets.empty()) return;
  auto place = std::ranges::find(figures, true, &ReportFigure::png);
  if (place == figures.end())
    place = figures.insert(figures.begin() + !figures.empty(), {.title = "the sheet", .caption = ""});
  place->sheets = std::move(sheets);
}

std::vector<ReportFigure> draw_all(const Result& result, const std::filesystem::path& run_folder) {
  const TemporaryFolder scratch("validate-report");
  std::vector<ReportFigure> figures;
  for (Drawing& drawing : drawings(result, run_folder)) {
    if (drawing.plot.panels.empty()) continue;
    const std::string name = fmt::format("figure{}", figures.size());
    draw(drawing.plot, scratch.path(), name, {drawing.figure.png ? PictureFormat::png : PictureFormat::svg});
    const auto file = scratch.path() / (name + (drawing.figure.png ? ".png" : ".svg"));
    if (std::filesystem::exists(file)) drawing.figure.content = read_file(file);
    if (is_chart(drawing.plot)) drawing.figure.chart = plot_json(drawing.plot);
    if (!drawing.figure.content.empty() || !drawing.figure.chart.empty()) figures.push_back(std::move(drawing.figure));
  }
  if (result.is_experiment()) add_sheets(figures, sheets_json(result, read_trajectories(run_folder / "run.h5")));
  return figures;
}

}  // namespace

std::string report_page(const Result& result, const std::filesystem::path& run_folder) {
  return report_html(result, draw_all(result, run_folder));
}

void write_report(const Result& result, const std::filesystem::path& run_folder, const std::filesystem::path& target) {
  write_file(target, report_page(result, run_folder));
}

}  // namespace validate
