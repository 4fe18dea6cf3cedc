// What the atomistic program leaves for the user: LAMMPS's logs and the deepest sheet of each load.
#pragma once

#include <filesystem>

#include "atomistic/sheet.hpp"
#include "compare/result.hpp"

namespace compare {

/// Joins `work`/*/log.lammps into `folder`/lammps.log. Throws Error (file failed).
void write_lammps_log(const std::filesystem::path& work, const std::filesystem::path& folder);

/// Writes `folder`/atoms-<load>.extxyz with the last finished level below `work`/<load>/steps, if there is one.
void write_deepest_sheet(const std::string& potential, const std::string& load, const atomistic::Sheet& sheet,
                         const std::filesystem::path& work, const std::filesystem::path& folder);

}  // namespace compare
