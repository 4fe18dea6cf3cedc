// One converged depth (R/55, disc of R/11) at growing radii: atoms, evaluations, where the time goes, memory, and the
// exponents with which they grow with the number of atoms. Radii in ascending order: the peak memory is the process's.
//
//   atomistic_scale [POTENTIAL] [RADIUS_A[,…]] [factor|multigrid] [LOAD]
//                                                    1000 Å takes some 12 GB and minutes with the factor
//
// Under mpiexec memory and user seconds are those of all ranks together.
#include <fmt/format.h>
#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "atomistic/ranks/mpi_team.hpp"
#include "tests/benchmark/atomistic/support.hpp"

namespace {

using namespace benchmark_support;

struct Row {
  double atoms, force_s, factor_s, solve_s, user_s, memory_GB;
};

double user_s(const rusage& usage) {
  return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

struct Asked {
  std::string potential, load;
  atomistic::Preconditioning preconditioning;
};

Row measure(const Asked& asked, double radius, const atomistic::MpiSession& session) {
  atomistic::Problem problem = disc_problem(asked.potential, radius, asked.load);
  problem.levels.resize(1);
  problem.preconditioning = asked.preconditioning;
  rusage before{}, after{};
  getrusage(RUSAGE_SELF, &before);
  const Path path = follow(problem, session);
  getrusage(RUSAGE_SELF, &after);
  const atomistic::Report& r = path.report;
  const atomistic::MpiTeam team;
  const double user = team.sum(user_s(after) - user_s(before)), memory = team.sum(static_cast<double>(after.ru_maxrss));
  if (team.rank() != 0) return {};
  const Row row{static_cast<double>(path.atoms), r.force_s + r.setup_s, r.factor_s, r.solve_s, user, memory / 1e6};
  const atomistic::Step& step = path.steps.front();
  fmt::print(
      "{:10} {:6.0f} {:9} {:6} {:9} {:9.1f} {:9.1f} {:9.1f} {:9.1f} {:9.1f} {:8.2f}   max|f| {:.1e}, F {:.9f}, error "
      "{:.1e}, {} solves\n",
      asked.potential, radius, path.atoms, step.evaluations, step.converged ? "yes" : "NO", row.force_s, row.factor_s,
      row.solve_s, row.user_s, path.wall_s, row.memory_GB, step.max_force_eV_per_A, step.force_eV_per_A,
      step.force_error_relative, step.solves);
  std::fflush(stdout);
  return row;
}

}  // namespace

int main(int argc, char** argv) {
  const atomistic::MpiSession session(&argc, &argv);
  const auto word = [&](int k, const char* otherwise) { return std::string(argc > k ? argv[k] : otherwise); };
  const Asked asked{
      word(1, "tersoff"), word(4, "disc"),
      word(3, "factor") == "factor" ? atomistic::Preconditioning::factor : atomistic::Preconditioning::multigrid};
  std::vector<Row> rows;
  if (session.rank() == 0)
    fmt::print(
        "potential   R (Å)     atoms evals. converged   force s  factor s   solve s    user s    wall s      GB\n");
  for (const std::string& radius : split(word(2, "30,110,300")))
    rows.push_back(measure(asked, std::stod(radius), session));
  if (session.rank() != 0) return 0;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const double growth = std::log(rows[k].atoms / rows[k - 1].atoms);
    const auto exponent = [&](double Row::*member) {
      return std::log(rows[k].*member / (rows[k - 1].*member)) / growth;
    };
    fmt::print("exponents {:.0f} → {:.0f} atoms: force {:.2f}, factor {:.2f}, solve {:.2f}, memory {:.2f}\n",
               rows[k - 1].atoms, rows[k].atoms, exponent(&Row::force_s), exponent(&Row::factor_s),
               exponent(&Row::solve_s), exponent(&Row::memory_GB));
  }
  return 0;
}
