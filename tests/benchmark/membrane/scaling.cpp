// CPU time per assembly, factorisation and load step, and peak memory, against the number of triangles, on
// one core.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include "membrane/triangles/factor.hpp"
#include "membrane/triangles/model.hpp"
#include "tests/benchmark/membrane/record_problem.hpp"

namespace {

using benchmark_problems::record_problem;

/// 6 × rings² triangles: 2 400, 48 600, 487 350 and 1 013 526; in this order, so that peaks of memory are
/// each size's own.
void sizes(benchmark::internal::Benchmark* b) {
  for (int rings : {20, 90, 285, 411}) b->Arg(rings);
  b->Unit(benchmark::kMillisecond);
}

/// Five load steps from flat, mesh and analysis included. First and in the order of sizes: each peak of memory is then
/// its own.
void path(benchmark::State& state) {
  const membrane::Problem problem = record_problem(static_cast<int>(state.range(0)));
  membrane::Report report;
  for (auto _ : state) report = membrane::solve(problem, [](const membrane::Step&) { return true; });
  if (!report.converged) state.SkipWithError(report.reason.c_str());
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  state.counters["triangles"] = report.elements;
  state.counters["factorisations"] = report.factorisations;
  state.counters["passes"] = report.assemblies;
  state.counters["peak_MB"] = used.ru_maxrss / 1024.0;
  state.counters["per_step"] =
      benchmark::Counter(static_cast<double>(problem.levels.size()),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(path)->Apply(sizes)->Iterations(1);

/// The problem of record on so many rings, bent as a tip would bend it.
struct BentSheet {
  membrane::Problem problem;
  membrane::Model model;
  Eigen::VectorXd u;

  explicit BentSheet(benchmark::State& state)
      : problem(record_problem(static_cast<int>(state.range(0)))), model(problem) {
    u = Eigen::VectorXd::Zero(model.energy().dof_count());
    for (int n = 0; n < model.mesh().node_count(); ++n)
      if (!model.mesh().held[n][2]) u[3 * n + 2] = -20 * (1 - model.mesh().nodes[n].norm() / 110);
    state.counters["triangles"] = static_cast<double>(model.mesh().triangles.size());
  }
};

void gradient(benchmark::State& state) {
  BentSheet sheet(state);
  Eigen::VectorXd gradient;
  for (auto _ : state) benchmark::DoNotOptimize(sheet.model.energy().energy(sheet.u, gradient));
}
BENCHMARK(gradient)->Apply(sizes);

void hessian(benchmark::State& state) {
  BentSheet sheet(state);
  for (auto _ : state) benchmark::DoNotOptimize(sheet.model.energy().hessian(sheet.u).valuePtr());
}
BENCHMARK(hessian)->Apply(sizes);

/// Numbers only: the analysis of the pattern is done once a mesh, and before.
void factorisation(benchmark::State& state) {
  BentSheet sheet(state);
  const auto& matrix = sheet.model.energy().hessian(sheet.u);
  membrane::Factor factor;
  factor.factorise(matrix);
  for (auto _ : state) benchmark::DoNotOptimize(factor.factorise(matrix));
}
BENCHMARK(factorisation)->Apply(sizes);

void analysis_and_factorisation(benchmark::State& state) {
  BentSheet sheet(state);
  const auto& matrix = sheet.model.energy().hessian(sheet.u);
  for (auto _ : state) benchmark::DoNotOptimize(membrane::Factor().factorise(matrix));
}
BENCHMARK(analysis_and_factorisation)->Apply(sizes);

}  // namespace

BENCHMARK_MAIN();
