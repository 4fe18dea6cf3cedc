#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "atomistic/cell/card.hpp"
#include "atomistic/lammps/lammps.hpp"
#include "compare/input/potential_file.hpp"

const atomistic::MpiSession& lammps_session();

inline atomistic::Potential potential(const std::string& name) {
  return validate::read_potential(name, VALIDATE_SOURCE_INPUTS "/potentials", "test").potential;
}

/// Every potential that the project ships.
inline std::vector<std::string> shipped_potentials() {
  return validate::available_potentials(VALIDATE_SOURCE_INPUTS "/potentials");
}

/// A potential's name as GoogleTest allows it.
inline std::string test_name(const testing::TestParamInfo<std::string>& potential) {
  std::string name = potential.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}
