// Time per factorisation, per pass and per path against the number of triangles, on one core.
#include <benchmark/benchmark.h>

#include "membrane/factor.hpp"
#include "membrane/model.hpp"
#include "tests/benchmark/membrane/record_problem.hpp"

namespace {

using benchmark_problems::record_problem;

/// 6 × rings² triangles: 2 400, 48 600, 486 000 and 1 014 000.
void sizes(benchmark::internal::Benchmark* b) {
  for (int rings : {20, 90, 285, 411}) b->Arg(rings);
  b->Unit(benchmark::kMillisecond);
}

Eigen::VectorXd bent(const membrane::Model& model, Eigen::Index dofs) {
  Eigen::VectorXd u = Eigen::VectorXd::Zero(dofs);
  for (int n = 0; n < model.mesh().node_count(); ++n)
    if (!model.mesh().held[n][2]) u[3 * n + 2] = -20 * (1 - model.mesh().nodes[n].norm() / 110);
  return u;
}

void factorisation(benchmark::State& state) {
  const membrane::Problem problem = record_problem(static_cast<int>(state.range(0)));
  membrane::Model model(problem);
  const Eigen::VectorXd u = bent(model, model.energy().dof_count());
  membrane::Factor factor;
  factor.factorise(model.energy().hessian(u));  // with the symbolic analysis
  for (auto _ : state) benchmark::DoNotOptimize(factor.factorise(model.energy().hessian(u)));
  state.counters["triangles"] = static_cast<double>(model.mesh().triangles.size());
}
BENCHMARK(factorisation)->Apply(sizes);

void pass(benchmark::State& state) {
  const membrane::Problem problem = record_problem(static_cast<int>(state.range(0)));
  membrane::Model model(problem);
  const Eigen::VectorXd u = bent(model, model.energy().dof_count());
  Eigen::VectorXd gradient;
  for (auto _ : state) benchmark::DoNotOptimize(model.energy().energy(u, gradient));
  state.counters["triangles"] = static_cast<double>(model.mesh().triangles.size());
}
BENCHMARK(pass)->Apply(sizes);

void path(benchmark::State& state) {
  const membrane::Problem problem = record_problem(static_cast<int>(state.range(0)));
  membrane::Report report;
  for (auto _ : state) report = membrane::solve(problem, [](const membrane::Step&) { return true; });
  state.counters["triangles"] = report.triangles;
  state.counters["factorisations"] = report.factorisations;
}
BENCHMARK(path)->Apply(sizes)->Iterations(1);

}  // namespace

BENCHMARK_MAIN();
