// Which programs, libraries and files made the numbers.
#pragma once

#include <string>

#include "compare/results/result.hpp"

namespace validate {

/// Versions of this program and of the libraries in this process; LAMMPS's comes from the atomistic program.
Provenance provenance(const std::string& command_line);

/// `20210929` → `29 Sep 2021`.
std::string lammps_release(int version);

/// The command line of this process, quoted where a word has spaces.
std::string command_line();

/// For --version: one library per line.
std::string version_text();

}  // namespace validate
