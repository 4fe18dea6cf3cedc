#include "compare/study/continua.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "compare/base/interrupt.hpp"
#include "compare/potential/law/states.hpp"
#include "compare/potential/law/variants.hpp"
#include "compare/results/sheet_columns.hpp"
#include "compare/study/curves.hpp"
#include "compare/verdict/explanation.hpp"

namespace validate {
namespace {

namespace axi = membrane::axisymmetric;

const Run* atoms_of(const Result& result, const std::string& load) {
  const auto found = std::ranges::find_if(
      result.runs, [&](const Run& run) { return run.model == Model::atomistic && run.load == load; });
  return found == result.runs.end() ? nullptr : &*found;
}

/// At a few depths as far as the law holds, which is enough for something so small and smooth. Dead loads only.
Anisotropy anisotropy_of(const SheetExperiment& sheet, const CalibratedLaw& law) {
  constexpr int parts = 3;
  const auto* disc = std::get_if<axi::DiscLoad>(&sheet.problem.load);
  if (!disc || sheet.run.conjugate_depth_A.empty() || law.sixfold.terms.empty()) return {};
  Anisotropy found;
  double deepest = 0;
  for (std::size_t i = 0; i < sheet.run.conjugate_depth_A.size(); ++i)
    if (sheet.run.longest_bond_A[i] <= longest_calibrated_bond_A)
      deepest = std::max(deepest, sheet.run.conjugate_depth_A[i]);
  if (!(deepest > 0)) return {};
  for (int i = 1; i <= parts; ++i) found.conjugate_depth_A.push_back(deepest * i / parts);
  found.ratio = anisotropy_ratios(law, sheet.problem.radius_A, disc->radius_A, found.conjugate_depth_A);
  found.conjugate_depth_A.resize(found.ratio.size());
  return found;
}

}  // namespace

void solve(MembraneExperiment& e, bool all_fields) {
  SheetAlbum album(e.problem, e.thickness_A, all_fields);
  const membrane::Report report = membrane::solve(e.problem, [&](const membrane::Step& step) {
    append(e.run, step);
    album.keep(step);
    return !interrupted();
  });
  close(e.run, report);
  e.run.pictures = std::make_shared<const std::vector<SheetPicture>>(album.pictures());
}

void solve(SheetExperiment& e) {
  bool left_the_law = false;
  const axi::SheetReport report = axi::solve(e.problem, [&](const axi::SheetStep& step) {
    if (!step.converged) return false;
    append(e.run, step, e.longest_bond, e.stretch);
    left_the_law = e.longest_bond && e.run.longest_bond_A.back() >= e.last_bond_A;
    return !left_the_law && !interrupted();
  });
  close(e.run, report);
  constexpr double near_breaking_A = 1.55;
  const std::vector<double>& bonds = e.run.longest_bond_A;
  if (!report.converged && !left_the_law && !bonds.empty() && bonds.back() >= near_breaking_A) {
    e.run.ended = Ended::rupture;
    e.run.ended_reason =
        fmt::format("the law bears no more: no equilibrium beyond a longest bond of {:.2f} Å", bonds.back());
  }
  if (!left_the_law) return;
  e.run.ended = Ended::artefact;
  e.run.ended_reason =
      fmt::format("the longest bond that the strains predict is {:.2f} Å", e.run.longest_bond_A.back());
}

void Continua::add_calibrated(std::array<SheetExperiment, 3> stages, SheetExperiment membrane, SheetExperiment sheet,
                              const CalibratedLaw& law) {
  calibrated_.push_back({std::move(stages), std::move(membrane), std::move(sheet), law, {}});
}

void Continua::start(bool all_fields) {
  thread_ = std::thread([this, all_fields] {
    const double begin = seconds();
    try {
      solve_all(all_fields);
    } catch (...) {
      failure_ = std::current_exception();
    }
    elapsed_s_ = seconds() - begin;
  });
}

void Continua::solve_all(bool all_fields) {
  for (MembraneExperiment& e : membranes_)
    if (!interrupted()) solve(e, all_fields);
  for (Calibrated& c : calibrated_) {
    for (SheetExperiment* e : {&c.sheet, &c.membrane, &c.stages[0], &c.stages[1], &c.stages[2]})
      if (!interrupted()) solve(*e);
    if (!interrupted()) c.anisotropy = anisotropy_of(c.sheet, c.law);
  }
}

double Continua::join() {
  thread_.join();
  if (failure_) std::rethrow_exception(failure_);
  return elapsed_s_;
}

void Continua::collect(Result& result) {
  for (const Calibrated& c : calibrated_) {
    const Run* atoms = atoms_of(result, c.sheet.run.load);
    if (!atoms) continue;
    auto explanation =
        explain(*atoms, {&c.stages[0].run, &c.stages[1].run, &c.stages[2].run, &c.sheet.run}, c.anisotropy);
    if (explanation) result.explanations.push_back(std::move(*explanation));
  }
  for (MembraneExperiment& e : membranes_) result.runs.push_back(std::move(e.run));
  for (Calibrated& c : calibrated_) {
    result.runs.push_back(std::move(c.membrane.run));
    result.runs.push_back(std::move(c.sheet.run));
  }
}

std::vector<double> enclosing(const std::vector<double>& levels) {
  constexpr double before = 0.5, beyond = 1.02;
  if (levels.empty()) return levels;
  std::vector<double> more = {before * levels.front()};
  more.insert(more.end(), levels.begin(), levels.end());
  more.push_back(beyond * levels.back());
  return more;
}

std::vector<double> with_halves(const std::vector<double>& levels) {
  std::vector<double> finer;
  for (const double level : levels) {
    if (!finer.empty()) finer.push_back((finer.back() + level) / 2);
    finer.push_back(level);
  }
  return finer;
}

}  // namespace validate
