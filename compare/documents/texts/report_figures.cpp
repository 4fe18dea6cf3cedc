// What the page of a run shows, drawn.
#include <fmt/format.h>
#include <stdlib.h>

#include <string>
#include <vector>

#include "compare/base/errors.hpp"
#include "compare/base/file.hpp"
#include "compare/base/read_file.hpp"
#include "compare/documents/plots/explanation_text.hpp"
#include "compare/documents/plots/fields.hpp"
#include "compare/documents/plots/figure.hpp"
#include "compare/documents/plots/figure_commands.hpp"
#include "compare/documents/plots/ratio_commands.hpp"
#include "compare/documents/plots/scan_commands.hpp"
#include "compare/documents/texts/report_html.hpp"

namespace validate {
namespace {

/// A folder for drawings that is removed at the end.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "validate-report-XXXXXX").string();
    if (!::mkdtemp(name.data()))
      throw Error(ExitCode::file_failed,
                  "cannot create a folder in " + std::filesystem::temp_directory_path().string());
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

struct Drawing {
  ReportFigure figure;  ///< its content is drawn
  std::string commands;
  DrawingSize size;
};

std::vector<Drawing> drawings(const Result& result, const std::filesystem::path& run_folder) {
  return {
      {{.content = {},
        .title = "force against depth",
        .caption =
            "Force against depth: atoms as markers (open in the artefact zone), the calibrated sheet as thick lines, "
            "membranes thin (dashed: the paper's constants), Eq. 16 black."},
       figure_commands(result),
       {}},
      {{.content = {},
        .title = "the sheet from above",
        .caption = "The deepest sheet from above: the atoms' longest bonds, and the membrane's larger "
                   "principal Cauchy "
                   "force (stress times thickness) under the same load.",
        .png = true},
       field_commands(result, run_folder),
       {1100, 500}},
      {{.content = {},
        .title = "atoms over membrane",
        .caption = "The atoms' force over that of each continuum at equal depth (open: artefact zone). Green: the "
                   "tolerance; dotted: the judged window."},
       ratio_commands(result),
       {900, 480}},
      {{.content = {},
        .title = "what a plain membrane lacks",
        .caption = "From a plain membrane (the paper's law with the card's constants, nominal radii) to the atoms, in "
                   "per cent of its force at the same depth: bars add up to the atoms' (squares)."},
       explanation_commands(result),
       {1000, 460}},
      {{.content = {},
        .title = "fits against the window",
        .caption = "Eq. 16 fitted up to increasing depths. Dashed: the constants of the curve. A result "
                   "that moves with "
                   "the window is not one number."},
       scan_commands(result),
       {900, 420}}};
}

std::vector<ReportFigure> draw_all(const Result& result, const std::filesystem::path& run_folder) {
  const ScratchFolder scratch;
  std::vector<ReportFigure> figures;
  for (Drawing& drawing : drawings(result, run_folder)) {
    if (drawing.commands.empty()) continue;
    const std::string name = fmt::format("figure{}", figures.size());
    draw(drawing.commands, scratch.path(), name, drawing.size);
    const auto file = scratch.path() / (name + (drawing.figure.png ? ".png" : ".svg"));
    if (!std::filesystem::exists(file)) continue;
    drawing.figure.content = read_file(file);
    figures.push_back(std::move(drawing.figure));
  }
  return figures;
}

}  // namespace

void write_report(const Result& result, const std::filesystem::path& run_folder, const std::filesystem::path& target) {
  write_file(target, report_html(result, draw_all(result, run_folder)));
}

}  // namespace validate
