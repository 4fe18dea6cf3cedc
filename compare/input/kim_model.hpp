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

/// Looks in the collections' folders (KIM_API_PORTABLE_MODELS_DIR, KIM_API_SIMULATOR_MODELS_DIR, then the system's).
std::optional<KimModel> find_kim_model(const std::string& name);

/// The same; throws Error (bad input) that says how models are installed and names the nearest one.
KimModel require_kim_model(const std::string& name, std::string_view label);

}  // namespace validate
