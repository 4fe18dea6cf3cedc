#include "compare/study/continua.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "compare/base/interrupt.hpp"
#include "compare/base/progress.hpp"
#include "compare/potential/law/variants.hpp"
#include "compare/results/sheet_columns.hpp"
#include "compare/study/curves.hpp"
#include "compare/study/meridian_curve.hpp"

namespace validate {
namespace {

/// At a few depths as far as the law holds, which is enough for something so small and smooth. Dead loads only.
Anisotropy anisotropy_of(const ContinuumExperiment& sheet, const CalibratedLaw& law) {
  constexpr int parts = 3;
  const auto* disc = std::get_if<membrane::DiscLoad>(&sheet.problem.load);
  if (!disc || sheet.run.conjugate_depth_A.empty() || law.sixfold.terms.empty()) return {};
  Anisotropy found;
  double deepest = 0;
  for (std::size_t i = 0; i < sheet.run.conjugate_depth_A.size(); ++i)
    if (sheet.run.longest_bond_A[i] <= law.range.holds_A) deepest = std::max(deepest, sheet.run.conjugate_depth_A[i]);
  if (!(deepest > 0)) return {};
  for (int i = 1; i <= parts; ++i) found.conjugate_depth_A.push_back(deepest * i / parts);
  found.ratio = anisotropy_ratios(law, sheet.run.a_A, disc->radius_A, found.conjugate_depth_A);
  found.conjugate_depth_A.resize(found.ratio.size());
  return found;
}

/// How far the middle of the right edge has come in; without a square's edge nothing is known.
double pull_in(const SheetPicture& picture) {
  const membrane::Mesh& mesh = picture.mesh;
  if (!mesh.edges.contains(membrane::Edge::right)) return not_known;
  const auto& edge = mesh.edges.at(membrane::Edge::right);
  const int middle =
      *std::ranges::min_element(edge, {}, [&](int n) { return std::abs(mesh.nodes[static_cast<std::size_t>(n)].y()); });
  return -picture.displacement[3 * static_cast<std::size_t>(middle)];
}

void append_extremes(ContinuumPart& part, const SheetPicture& picture) {
  const auto& larger = column(picture.triangles, "cauchy_1_eV_per_A3");
  const auto& smaller = column(picture.triangles, "cauchy_2_eV_per_A3");
  part.wrinkled_area_fraction.push_back(total(picture.totals, "wrinkled_area_fraction"));
  part.slack_area_fraction.push_back(total(picture.totals, "slack_area_fraction"));
  part.edge_pull_in_A.push_back(pull_in(picture));
  part.stress_1_max_eV_per_A3.push_back(std::ranges::max(larger));
  part.stress_2_min_eV_per_A3.push_back(std::ranges::min(smaller));
  part.stress_2_max_eV_per_A3.push_back(std::ranges::max(smaller));
}

/// What a sheet that bends has for wrinkles, and how firmly.
void append_folds(ContinuumExperiment& e, const membrane::Mesh& mesh, const membrane::Step& step) {
  const membrane::TriangleShape& shape = step.on_triangles();
  append(e.run, wrinkles_of(points_of(mesh, shape), e.run.a_A));
  e.run.continuum().softest_eV_per_A2.push_back(shape.softest_eV_per_A2.value_or(not_known));
  e.run.continuum().saddles_left.push_back(shape.saddles_left);
}

void solve_triangles(ContinuumExperiment& e, bool all_fields) {
  const membrane::Problem& problem = e.problem;
  const bool pressed = e.run.load == LoadKind::pressure;
  SheetAlbum album(problem, e.thickness_A, all_fields || pressed);
  const membrane::Mesh mesh = membrane::mesh_of(problem);
  const membrane::Report report = membrane::solve(problem, [&](const membrane::Step& step) {
    append(e.run, step);
    album.keep(step);
    if (pressed) append_extremes(e.run.continuum(), picture_of(problem, step, e.thickness_A));
    if (e.run.compression && problem.bending) append_folds(e, mesh, step);
    return !interrupted();
  });
  close(e.run, report);
  e.run.continuum().triangles = report.elements;
  e.run.continuum().pictures = std::make_shared<const std::vector<SheetPicture>>(album.pictures());
}

bool on_triangles(const ContinuumExperiment& e) {
  return std::holds_alternative<membrane::Triangles>(e.problem.discretisation);
}

/// Triangles first, since they are slow; the calibrated sheet before what only explains it.
std::vector<ContinuumExperiment*> in_order(std::vector<PairedLoad>& loads) {
  std::vector<ContinuumExperiment*> order;
  const auto add = [&](bool triangles) {
    for (PairedLoad& load : loads)
      for (ContinuumExperiment& e : load.continua)
        if (on_triangles(e) == triangles) order.push_back(&e);
  };
  add(true);
  add(false);
  return order;
}

}  // namespace

void solve(ContinuumExperiment& e, bool all_fields, bool to_the_end) {
  if (on_triangles(e))
    solve_triangles(e, all_fields);
  else
    solve_on_meridian(e, to_the_end);
}

Continua::Continua(std::vector<PairedLoad>& loads, const CalibratedLaw* law, bool all_fields)
    : loads_(loads), law_(law), all_fields_(all_fields), thread_([this] {
        const double begin = seconds();
        try {
          solve_all();
        } catch (...) {
          failure_ = std::current_exception();
        }
        elapsed_s_ = seconds() - begin;
      }) {}

void Continua::solve_all() {
  for (ContinuumExperiment* e : in_order(loads_))
    if (!interrupted()) solve(*e, all_fields_);
  for (const PairedLoad& load : loads_) {
    const ContinuumExperiment* sheet = load.find(Purpose::calibrated_sheet);
    if (sheet && law_ && load.find(Purpose::bending) && !interrupted())
      anisotropies_[load.load] = anisotropy_of(*sheet, *law_);
  }
}

double Continua::join() {
  thread_.join();
  if (failure_) std::rethrow_exception(failure_);
  return elapsed_s_;
}

}  // namespace validate
