// The problem of record: a clamped disc under a tip, solved whole.
#pragma once

#include "membrane/problem.hpp"

namespace benchmark_problems {

/// a = 110 Å, E·h = 8.03368 eV/Å², nu = 0.19, pretension 0.02 eV/Å², disc of 11 Å, 20 eV/Å in five equal steps, on the
/// full disc of 6 × rings² triangles: 48 600 with 90 rings. Centre depth 27.1627 Å (one-dimensional solver).
inline membrane::Problem record_problem(int rings = 90) {
  membrane::Problem problem;
  problem.sheet = membrane::DiscSheet{.radius_A = 110, .rings = rings, .extent = membrane::Extent::full};
  problem.law = membrane::StVenantKirchhoff{8.03368, 0.19};
  problem.prestress_eV_per_A2 = 0.02 * Eigen::Matrix2d::Identity();
  problem.load = membrane::DiscLoad{11};
  problem.control = membrane::Control::force;
  problem.levels = {4, 8, 12, 16, 20};
  return problem;
}

}  // namespace benchmark_problems
