// Where the program's own data and its atomistic companion are, from any current directory.
#pragma once

#include <filesystem>
#include <string_view>

namespace validate {

/// Whether there is something of this name, for walks over places that others name: what cannot be looked at is not
/// there.
bool is_there(const std::filesystem::path& path);

/// Folder of the running program, links resolved.
std::filesystem::path program_folder();

/// The folder with the case files and `potentials/`: `from_environment` unless it is empty, else ../inputs
/// (build tree) or ../share/validate (installed) as seen from the program's folder. Throws Error (bad input)
/// naming the places searched.
std::filesystem::path find_inputs(const std::filesystem::path& program_folder, std::string_view from_environment);

/// The same for this program and the variable VALIDATE_INPUTS.
std::filesystem::path inputs_folder();

/// `validate-atoms` beside the program. Throws Error (atomistic failed) if it is not there.
std::filesystem::path atoms_program();

}  // namespace validate
