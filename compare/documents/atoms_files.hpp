// What the atomistic program leaves for the user: LAMMPS's logs and the deepest sheet of each load.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "atomistic/lattice/sheet.hpp"
#include "compare/results/result.hpp"
#include "compare/results/trajectory.hpp"

namespace validate {

/// Joins `work`/*/log.lammps into `folder`/lammps.log. Throws Error (file failed).
void write_lammps_log(const std::filesystem::path& work, const std::filesystem::path& folder);

/// The flat sheet and the finished levels of the way there below `work`/<load>/steps; nothing where there are none.
std::optional<AtomsTrajectory> trajectory_of(const std::string& load, const atomistic::Sheet& sheet,
                                             const std::filesystem::path& work);

/// Writes the last finished level of the way there below `work`/<load>/steps, if there is one, as
/// `folder`/atoms-<load>.extxyz and as a LAMMPS data file, atoms-<load>.data.
void write_deepest_sheet(const atomistic::Potential& potential, const std::string& load, const atomistic::Sheet& sheet,
                         const std::filesystem::path& work, const std::filesystem::path& folder);

}  // namespace validate
