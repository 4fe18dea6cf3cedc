#include "compare/documents/experiment_files.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <iterator>
#include <mutex>
#include <thread>
#include <vector>

#include "compare/base/file.hpp"
#include "compare/documents/atoms_files.hpp"
#include "compare/documents/bytes/run_h5.hpp"
#include "compare/documents/bytes/vtu.hpp"
#include "compare/documents/plots/draw.hpp"
#include "compare/documents/plots/explanation_bars.hpp"
#include "compare/documents/plots/force_depth.hpp"
#include "compare/documents/plots/pressed_atoms_plot.hpp"
#include "compare/documents/plots/pulled_rim_plot.hpp"
#include "compare/documents/plots/ratio.hpp"
#include "compare/documents/plots/sheet_maps.hpp"
#include "compare/documents/plots/thermal_plot.hpp"
#include "compare/documents/plots/window_scan.hpp"
#include "compare/documents/texts/curves_csv.hpp"
#include "compare/documents/texts/json.hpp"
#include "compare/documents/texts/report_html.hpp"
#include "compare/process/atoms.hpp"
#include "compare/results/pulled_rim.hpp"

namespace validate {
namespace {

namespace fs = std::filesystem;

struct Target {
  const StudyOutcome& outcome;
  const Result& result;
  const fs::path &work, &folder;
  std::vector<AtomsOfLoad> atoms;
};

void run_h5(const Target& t) {
  std::vector<AtomsTrajectory> trajectories;
  for (const AtomsOfLoad& one : t.atoms) trajectories.push_back(one.trajectory);
  write_run_h5(t.result, t.folder / "run.h5", trajectories);
}
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
  for (const AtomsOfLoad& one : t.atoms) write_deepest_sheet(t.outcome.potential, one, *t.outcome.sheet, t.folder);
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
  Plot plot = pulled_rim_plot(t.result);
  if (plot.panels.empty()) plot = pressed ? sheet_plot(*pressed) : force_depth_plot(t.result);
  tell(write_plot(plot, t.folder, "figure"));
}

void narrow_figure(const Target& t) {
  if (!pressed_sheet(t.result) && !has_pulled_rim(t.result))
    tell(draw(narrow_force_depth_plot(t.result), t.folder, "figure-narrow", {PictureFormat::pdf}));
}

void pressed_atoms(const Target& t) { tell(write_plot(pressed_atoms_plot(t.result), t.folder, "atoms")); }
void ratio(const Target& t) { tell(write_plot(ratio_plot(t.result), t.folder, "ratio")); }
void explained(const Target& t) { tell(write_plot(explanation_plot(t.result), t.folder, "explanation")); }
void temperature(const Target& t) { tell(write_plot(thermal_plot(t.result), t.folder, "thermal")); }
void scan(const Target& t) { tell(write_plot(window_scan_plot(t.result), t.folder, "window_scan")); }

/// The page shows the sheets that were written before it.
void page(const Target& t) { write_report(t.result, t.folder, t.folder / "report.html"); }

/// Numbers first. A further document is a function and a line here.
using Write = void (*)(const Target&);
constexpr Write documents[] = {run_h5, curves, summary, logs, atoms, sheets};

/// Each a gnuplot of its own, side by side; the page shows the sheets that were written before it.
constexpr Write pictures[] = {page, figure, narrow_figure, ratio, scan, explained, pressed_atoms, temperature};

/// Keeps the first failure: what one document fails at does not take the others away.
class Failures {
 public:
  void guard(Write write, const Target& target) {
    try {
      write(target);
    } catch (const std::exception&) {
      const std::lock_guard lock(mutex_);
      if (!first_) first_ = std::current_exception();
    }
  }
  void rethrow() const {
    if (first_) std::rethrow_exception(first_);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr first_;
};

}  // namespace

void write_experiment(const StudyOutcome& outcome, const fs::path& work, const fs::path& folder) {
  Target target{outcome, outcome.result, work, folder, {}};
  if (outcome.sheet) target.atoms = read_atoms(outcome.result.resolved.loads, *outcome.sheet, work);
  Failures failures;
  for (const Write write : documents) failures.guard(write, target);
  std::atomic<std::size_t> next = 0;
  const auto draw_some = [&] {
    for (std::size_t i = next++; i < std::size(pictures); i = next++) failures.guard(pictures[i], target);
  };
  {
    std::vector<std::jthread> others;
    const int cores = std::min(available_cores(), static_cast<int>(std::size(pictures)));
    for (int i = 1; i < cores; ++i) others.emplace_back(draw_some);
    draw_some();
  }
  failures.rethrow();
}

}  // namespace validate
