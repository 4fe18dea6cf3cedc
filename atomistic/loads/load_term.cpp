#include "atomistic/loads/load_term.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "atomistic/loads/pattern_load.hpp"
#include "atomistic/loads/pressure_load.hpp"
#include "atomistic/loads/sphere_load.hpp"

namespace atomistic {
namespace {

std::vector<int> free_atoms(const Sheet& sheet) {
  std::vector<int> all(static_cast<std::size_t>(sheet.free_atoms));
  for (int k = 0; k < sheet.free_atoms; ++k) all[k] = k;
  return all;
}

struct LoadedAtoms {
  const Sheet& sheet;
  std::vector<int> operator()(const PointLoad&) const { return sheet.innermost; }
  std::vector<int> operator()(const DiscLoad& disc) const { return atoms_within(sheet, disc.radius_A); }
  std::vector<int> operator()(const SphereLoad& sphere) const { return atoms_within(sheet, sphere.radius_A); }
  std::vector<int> operator()(const PressureLoad&) const { return free_atoms(sheet); }
};

struct MakeLoad {
  const Problem& problem;
  const Sheet& sheet;
  const Team& team;
  using Made = std::unique_ptr<LoadTerm>;
  Made operator()(const PointLoad& load) const {
    return std::make_unique<PatternLoad>(LoadedAtoms{sheet}(load), problem, sheet, team);
  }
  Made operator()(const DiscLoad& load) const {
    return std::make_unique<PatternLoad>(LoadedAtoms{sheet}(load), problem, sheet, team);
  }
  Made operator()(const SphereLoad& load) const { return std::make_unique<SphereTerm>(load, problem, sheet, team); }
  Made operator()(const PressureLoad& load) const { return std::make_unique<PressureTerm>(load, problem, sheet); }
};

}  // namespace

std::vector<int> loaded_atoms(const Load& load, const Sheet& sheet) { return std::visit(LoadedAtoms{sheet}, load); }

std::unique_ptr<LoadTerm> make_load(const Problem& problem, const Sheet& sheet, const Team& team) {
  return std::visit(MakeLoad{problem, sheet, team}, problem.load);
}

Eigen::VectorXd schwerin_shape(const Sheet& sheet, double depth_A, double core_radius_A) {
  const double core = core_radius_A / sheet.radius_A, at_core = std::pow(core, 2.0 / 3.0);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(3 * sheet.free_atoms);
  for (int i = 0; i < sheet.free_atoms; ++i) {
    const double r = std::min(1.0, sheet.position(i).head<2>().norm() / sheet.radius_A);
    const double risen = r < core ? at_core * (1 + (r * r / (core * core) - 1) / 3) : std::pow(r, 2.0 / 3.0);
    u[3 * i + 2] = -depth_A * (1 - risen);
  }
  return u;
}

double rough_force(const Problem& problem, double depth_A) {
  const double membrane = problem.card.sheet_modulus_eV_per_A2() * std::pow(depth_A, 3);
  const double plate = 16 * std::numbers::pi * problem.card.bending_modulus_eV() * depth_A;
  return (membrane + plate) / (problem.radius_A * problem.radius_A);
}

double rough_depth(const Problem& problem, double force_eV_per_A) {
  double low = 0, high = problem.radius_A;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (rough_force(problem, middle) < force_eV_per_A ? low : high) = middle;
  }
  return high;
}

}  // namespace atomistic
