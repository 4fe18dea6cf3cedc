// Solves the problem of record once and prints what it took as JSON: membrane_record [rings].
#include <sys/resource.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>

#include "tests/benchmark/membrane/record_problem.hpp"

int main(int argc, char** argv) {
  const membrane::Problem problem = benchmark_problems::record_problem(argc > 1 ? std::atoi(argv[1]) : 90);
  const auto start = std::chrono::steady_clock::now();
  nlohmann::ordered_json depths = nlohmann::json::array(), residuals = nlohmann::json::array();
  const membrane::Report report = membrane::solve(problem, [&](const membrane::Step& step) {
    depths.push_back(step.depth_A);
    residuals.push_back(step.relative_residual);
    return true;
  });
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  const auto seconds = [](const timeval& t) { return t.tv_sec + 1e-6 * t.tv_usec; };
  const nlohmann::ordered_json document{{"triangles", report.elements},
                                        {"steps", depths.size()},
                                        {"converged", report.converged},
                                        {"factorisations", report.factorisations},
                                        {"passes", report.assemblies},
                                        {"wall_s", wall.count()},
                                        {"cpu_s", seconds(used.ru_utime) + seconds(used.ru_stime)},
                                        {"peak_MB", used.ru_maxrss / 1024.0},
                                        {"centre_depth_A", depths},
                                        {"residual", residuals}};
  std::cout << document.dump(1) << '\n';
  return report.converged ? 0 : 1;
}
