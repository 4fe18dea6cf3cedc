// What the atomistic benchmarks share: problems by name, and whole paths.
#pragma once

#include <string>
#include <vector>

#include "atomistic/equilibrium/indentation.hpp"

namespace benchmark_support {

struct Path {
  std::vector<atomistic::Step> steps;
  atomistic::Report report;
  int atoms = 0;
  double wall_s = 0;
};

std::vector<std::string> split(const std::string& comma_separated);
std::vector<std::string> shipped_potentials();
atomistic::Potential potential(const std::string& name);
const atomistic::Card& card(const std::string& name);  ///< computed once
std::string name_of(atomistic::Ended ended);

/// A clamped disc; depths R/55, 2 R/55, … 0.2 R. The load is point, disc (radius R/11) or sphere (radius R/4).
atomistic::Problem disc_problem(const std::string& potential_name, double radius_A, const std::string& load);

/// On one rank; the steps keep no positions.
Path follow(const atomistic::Problem& problem, const atomistic::MpiSession& session);

}  // namespace benchmark_support
