// A path's last state: what it claims, found again from LAMMPS's forces at its positions.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "atomistic/lattice/sheet.hpp"
#include "atomistic/loads/load_term.hpp"
#include "compare/verify_atoms/groups.hpp"

namespace validate::verify {
namespace {

using atomistic::Problem;
using atomistic::Sheet;
using atomistic::Step;
using Eigen::VectorXd;

constexpr double radius_A = 20, tip_A = 6, step_A = 0.5;
constexpr int levels = 8;

Problem disc_problem(Laboratory& laboratory, const std::string& potential) {
  std::vector<double> depths;
  for (int k = 1; k <= levels; ++k) depths.push_back(k * step_A);
  Problem problem = laboratory.problem(potential, radius_A, atomistic::DiscLoad{tip_A}, depths);
  problem.force_tolerance_eV_per_A = 1e-7;
  return problem;
}

/// Forces on the free atoms with the load added, and what carries it.
void forces_again(Ledger& ledger, Laboratory& laboratory, const std::string& potential, const Problem& problem,
                  const Step& last) {
  const Sheet sheet =
      atomistic::make_sheet(problem.radius_A, problem.card.a0_A, 0, problem.potential.interaction_range_A);
  const std::vector<int> loaded = atomistic::loaded_atoms(problem.load, sheet);
  VectorXd f = laboratory.forces(potential, {last.positions})[0].forces_eV_per_A;
  double carried = 0, on_rim = 0;
  for (const int atom : loaded) carried += f[3 * atom + 2];
  for (int atom = sheet.free_atoms; atom < sheet.atoms(); ++atom) on_rim += f[3 * atom + 2];
  ledger.equal("force of the loaded atoms / the load", carried / last.force_eV_per_A,
               identity(1, "the load is what LAMMPS's forces say"), 1e-6, fmt::format("{} atoms", loaded.size()));
  ledger.equal("force on the rim / the load", -on_rim / last.force_eV_per_A, identity(1, "the rim carries the load"),
               1e-4);
  const double share = last.force_eV_per_A / static_cast<double>(loaded.size());
  for (const int atom : loaded) f[3 * atom + 2] -= share;
  double most = 0;
  for (int atom = 0; atom < sheet.free_atoms; ++atom) most = std::max(most, f.segment<3>(3 * atom).norm());
  ledger.at_most("largest force left on a free atom, eV/Å", most,
                 identity(2e-7, "stationary to the 1e-7 asked for, and rounding"), "equal shares of the load removed");
}

/// Simpson's rule over the last two steps: fourth order.
void work(Ledger& ledger, const std::vector<Step>& steps) {
  const Step &a = steps[levels - 3], &b = steps[levels - 2], &c = steps[levels - 1];
  const double done = (a.force_eV_per_A + 4 * b.force_eV_per_A + c.force_eV_per_A) * step_A / 3;
  ledger.equal("energy gained / work of the force", (c.energy_eV - a.energy_eV) / done,
               identity(1, "force over its conjugate depth is the energy"), 1e-3, "Simpson's rule, steps of 0.5 Å");
}

void two_ranks(Ledger& ledger, Laboratory& laboratory, const Problem& problem, const Step& last) {
  if (!has_mpiexec()) return;
  const std::vector<Step> other = laboratory.path(problem, 2);
  ledger.equal("force on two ranks / on one", other.back().force_eV_per_A / last.force_eV_per_A,
               identity(1, "the order of a sum changes nothing"), 1e-6);
}

}  // namespace

void verify_equilibrium(Ledger& ledger, Laboratory& laboratory) {
  for (const std::string& potential : laboratory.potentials()) {
    ledger.begin(fmt::format("{}, R = 20 Å, disc of 6 Å, 4 Å deep", potential));
    const Problem problem = disc_problem(laboratory, potential);
    const std::vector<Step> steps = laboratory.path(problem, 1);
    ledger.equal("levels reached", static_cast<double>(steps.size()), identity(levels, "all that were asked for"), 0);
    if (steps.size() != levels) continue;
    forces_again(ledger, laboratory, potential, problem, steps.back());
    work(ledger, steps);
    two_ranks(ledger, laboratory, problem, steps.back());
  }
}

}  // namespace validate::verify
