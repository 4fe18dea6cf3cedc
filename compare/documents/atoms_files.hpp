// What the atomistic program leaves for the user: LAMMPS's logs and the deepest sheet of each load.
#pragma once

#include <filesystem>
#include <vector>

#include "atomistic/lattice/sheet.hpp"
#include "atomistic/problem.hpp"
#include "compare/results/result.hpp"
#include "compare/results/trajectory.hpp"

namespace validate {

/// Joins `work`/*/log.lammps into `folder`/lammps.log. Throws Error (file failed).
void write_lammps_log(const std::filesystem::path& work, const std::filesystem::path& folder);

/// What one load's steps hold for the documents.
struct AtomsOfLoad {
  AtomsTrajectory trajectory;
  atomistic::Step deepest;  ///< the last finished level of the way there
};

/// Reads `work`/<load>/steps of every load that has some.
std::vector<AtomsOfLoad> read_atoms(const std::vector<LoadKind>& loads, const atomistic::Sheet& sheet,
                                    const std::filesystem::path& work);

/// Writes the deepest sheet as `folder`/atoms-<load>.extxyz and as a LAMMPS data file, atoms-<load>.data.
void write_deepest_sheet(const atomistic::Potential& potential, const AtomsOfLoad& atoms, const atomistic::Sheet& sheet,
                         const std::filesystem::path& folder);

}  // namespace validate
