#include "compare/documents/experiment_files.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <exception>

#include "compare/base/file.hpp"
#include "compare/documents/atoms_files.hpp"
#include "compare/documents/bytes/run_h5.hpp"
#include "compare/documents/bytes/vtu.hpp"
#include "compare/documents/plots/draw.hpp"
#include "compare/documents/plots/force_depth.hpp"
#include "compare/documents/plots/pressed_atoms_plot.hpp"
#include "compare/documents/plots/sheet_maps.hpp"
#include "compare/documents/plots/window_scan.hpp"
#include "compare/documents/texts/curves_csv.hpp"
#include "compare/documents/texts/json.hpp"
#include "compare/documents/texts/report_html.hpp"

namespace validate {
namespace {

namespace fs = std::filesystem;

struct Target {
  const StudyOutcome& outcome;
  const Result& result;
  const fs::path &work, &folder;
};

void run_h5(const Target& t) { write_run_h5(t.result, t.folder / "run.h5"); }
void curves(const Target& t) { write_curves(t.result, t.folder); }
void summary(const Target& t) { write_file(t.folder / "summary.json", json_text(t.result)); }

/// A .pvd and its VTU files for every membrane whose sheet was kept.
void sheets(const Target& t) {
  for (const Run& run : t.result.runs) {
    if (run.is_atomistic() || !run.continuum().pictures || run.continuum().pictures->empty()) continue;
    const bool pressed = run.load == LoadKind::pressure;
    write_pvd(*run.continuum().pictures, t.folder,
              pressed ? "membrane" : fmt::format("membrane-{}-{}", run.load, *run.constants));
  }
}

void logs(const Target& t) {
  if (fs::exists(t.work)) write_lammps_log(t.work, t.folder);
}

void atoms(const Target& t) {
  if (!t.outcome.sheet) return;
  for (const LoadKind load : t.result.resolved.loads)
    write_deepest_sheet(t.outcome.potential, std::string(to_string(load)), *t.outcome.sheet, t.work, t.folder);
}

void tell(const std::optional<std::string>& warning) {
  if (warning) spdlog::warn("{}", *warning);
}

/// The sheet of triangles under a pressure, if there is one.
const SheetPicture* pressed_sheet(const Result& result) {
  for (const Run& run : result.runs)
    if (run.load == LoadKind::pressure && run.model == Model::membrane && run.continuum().pictures &&
        !run.continuum().pictures->empty())
      return &run.continuum().pictures->back();
  return nullptr;
}

void figure(const Target& t) {
  const SheetPicture* pressed = pressed_sheet(t.result);
  tell(write_plot(pressed ? sheet_plot(*pressed) : force_depth_plot(t.result), t.folder, "figure"));
}

void pressed_atoms(const Target& t) { tell(write_plot(pressed_atoms_plot(t.result), t.folder, "atoms")); }
void scan(const Target& t) { tell(write_plot(window_scan_plot(t.result), t.folder, "window_scan")); }

/// The page shows the sheets that were written before it.
void page(const Target& t) { write_report(t.result, t.folder, t.folder / "report.html"); }

/// Numbers first, pictures last. A further document is a function and a line here.
using Write = void (*)(const Target&);
constexpr Write documents[] = {run_h5, curves, summary, logs, atoms, sheets, figure, pressed_atoms, scan, page};

}  // namespace

void write_experiment(const StudyOutcome& outcome, const fs::path& work, const fs::path& folder) {
  const Target target{outcome, outcome.result, work, folder};
  std::exception_ptr first_failure;
  for (const Write write : documents) {
    try {
      write(target);
    } catch (const std::exception&) {
      if (!first_failure) first_failure = std::current_exception();
    }
  }
  if (first_failure) std::rethrow_exception(first_failure);
}

}  // namespace validate
