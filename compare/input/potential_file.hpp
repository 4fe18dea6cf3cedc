// A potential: one TOML file that names LAMMPS's pair style, its coefficients and the file of parameters.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "atomistic/problem.hpp"

namespace validate {

struct PotentialFile {
  atomistic::Potential potential;  ///< pair_coeff still holds {file}; file is an absolute path, or empty
  std::filesystem::path toml;      ///< the description that was read
  std::string sha256;              ///< of the parameter file, or of the OpenKIM model's library
  std::string switch_parameter;    ///< name of the cut-off switch in the file; empty: none that can be moved
  std::string edit;                ///< what a copy of the file was changed to; empty: the file as it is
  std::vector<std::string> warnings;
};

/// True for `my.toml` and `here/my.toml`: a path, not a name in inputs/potentials.
bool is_path(std::string_view potential);

/// Names in a folder of potentials, sorted.
std::vector<std::string> available_potentials(const std::filesystem::path& folder);

/// Folders searched for a parameter file named without a path: beside the TOML, $LAMMPS_POTENTIALS, LAMMPS's
/// own.
std::vector<std::filesystem::path> places_for_parameters(const std::filesystem::path& toml);

/// Whether a description, which may come from others, may make LAMMPS run a program.
enum class CodeInPotential { refused, allowed };

/// Reads a potential by name (in `folder`; `kim/hnn-2019` is one too) or by path (from the current directory) and
/// checks that its parameter file exists, can be read, holds what the description says and suits the pair style, so
/// that LAMMPS never sees a bad one; a file with other parameters than the description was written for is a warning.
/// `label` (flag, or file and line) starts the messages. Throws Error: bad input, a pair style that runs code among it;
/// file failed if unreadable.
PotentialFile read_potential(std::string_view name_or_path, const std::filesystem::path& folder, std::string_view label,
                             CodeInPotential code = CodeInPotential::refused);

}  // namespace validate
