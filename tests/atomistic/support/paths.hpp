// Problems and whole paths for the tests through LAMMPS.
#pragma once

#include <string>
#include <vector>

#include "atomistic/equilibrium/indentation.hpp"
#include "tests/atomistic/support/lammps_session.hpp"

const atomistic::Card& card_of(const std::string& name);  ///< computed once

atomistic::Problem problem_of(const std::string& name, double radius, atomistic::Load load, std::vector<double> levels);

struct Path {
  std::vector<atomistic::Step> steps;
  atomistic::Report report;
};

Path follow(const atomistic::Problem& p, const std::vector<atomistic::Step>& finished = {});
