#include "compare/documents/atoms_files.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <vector>

#include "atomistic/protocol/data_file.hpp"
#include "atomistic/protocol/step_file.hpp"
#include "compare/base/file.hpp"
#include "compare/documents/bytes/extxyz.hpp"

namespace validate {
namespace {

namespace fs = std::filesystem;

std::vector<Eigen::Vector3d> by_atom(const Eigen::VectorXd& flat) {
  std::vector<Eigen::Vector3d> all;
  for (Eigen::Index i = 0; i < flat.size(); i += 3) all.emplace_back(flat.segment<3>(i));
  return all;
}

std::vector<double> longest_bond_by_atom(const atomistic::Sheet& sheet, const std::vector<Eigen::Vector3d>& x) {
  std::vector<double> longest(x.size(), 0.0);
  for (std::size_t i = 0; i < x.size(); ++i)
    for (int j : sheet.neighbours[i])
      if (j >= 0) longest[i] = std::max(longest[i], (x[i] - x[static_cast<std::size_t>(j)]).norm());
  return longest;
}

/// The flat sheet, and what is whole of the steps.
AtomsTrajectory trajectory_of(const std::string& load, const atomistic::Sheet& sheet,
                              const std::vector<atomistic::Step>& steps) {
  AtomsTrajectory t{.load = load,
                    .atoms = static_cast<std::size_t>(sheet.atoms()),
                    .free_atoms = static_cast<std::size_t>(sheet.free_atoms)};
  t.positions_A.reserve((steps.size() + 1) * static_cast<std::size_t>(sheet.positions.size()));
  const auto add = [&t](double depth_A, double force_eV_per_A, const Eigen::VectorXd& positions) {
    t.depth_A.push_back(depth_A), t.force_eV_per_A.push_back(force_eV_per_A);
    t.positions_A.insert(t.positions_A.end(), positions.begin(), positions.end());
  };
  add(0, 0, sheet.positions);
  for (const atomistic::Step& step : steps)
    if (!step.broken && step.positions.size() == sheet.positions.size())
      add(step.depth_A, step.force_eV_per_A, step.positions);
  return t;
}

}  // namespace

void write_lammps_log(const fs::path& work, const fs::path& folder) {
  std::set<fs::path> logs;
  for (const auto& entry : fs::directory_iterator(work))
    if (fs::exists(entry.path() / "log.lammps")) logs.insert(entry.path() / "log.lammps");
  if (logs.empty()) return;
  std::string all;
  for (const fs::path& log : logs) {
    std::ifstream in(log);
    all += fmt::format("# ---- {}\n", log.parent_path().filename().string());
    all.append(std::istreambuf_iterator<char>(in), {});
  }
  write_file(folder / "lammps.log", all);
}

std::vector<AtomsOfLoad> read_atoms(const std::vector<LoadKind>& loads, const atomistic::Sheet& sheet,
                                    const fs::path& work) {
  std::vector<AtomsOfLoad> all;
  for (const LoadKind load : loads) {
    std::vector<atomistic::Step> steps = atomistic::read_way_there(work / std::string(to_string(load)) / "steps");
    if (steps.empty()) continue;
    AtomsOfLoad& one = all.emplace_back();
    one.trajectory = trajectory_of(std::string(to_string(load)), sheet, steps);
    one.deepest = std::move(steps.back());
  }
  return all;
}

void write_deepest_sheet(const atomistic::Potential& potential, const AtomsOfLoad& atoms, const atomistic::Sheet& sheet,
                         const fs::path& folder) {
  const std::string& load = atoms.trajectory.load;
  const atomistic::Step& step = atoms.deepest;
  const std::vector<Eigen::Vector3d> positions = by_atom(step.positions), forces = by_atom(step.forces);
  const std::vector<double> longest = longest_bond_by_atom(sheet, positions);
  std::vector<int> clamped(positions.size(), 1);
  std::fill_n(clamped.begin(), sheet.free_atoms, 0);
  write_extxyz({.potential = potential.name,
                .load = load,
                .depth_A = step.depth_A,
                .force_eV_per_A = step.force_eV_per_A,
                .positions_A = positions,
                .forces_eV_per_A = forces,
                .longest_bond_A = longest,
                .clamped = clamped},
               folder / fmt::format("atoms-{}.extxyz", load));
  write_file(folder / fmt::format("atoms-{}.data", load), atomistic::data_file(potential, step.positions));
}

}  // namespace validate
