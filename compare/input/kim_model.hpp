// OpenKIM models on this machine (the package openkim-models, or the user's own collection).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace validate {

struct KimModel {
  std::string name;
  bool simulator = false;         ///< sets LAMMPS commands itself; else portable: pair_style kim
  std::filesystem::path library;  ///< what was installed, for its hash
};

/// Letters, digits and _: never a path, from which OpenKIM would load a library.
bool is_kim_name(std::string_view name);

/// Looks in the collections' folders (KIM_API_PORTABLE_MODELS_DIR, KIM_API_SIMULATOR_MODELS_DIR, then the system's).
std::optional<KimModel> find_kim_model(const std::string& name);

/// The same; throws Error (bad input) for what is no name, and one that says how models are installed and names the
/// nearest one.
KimModel require_kim_model(const std::string& name, std::string_view label);

}  // namespace validate
