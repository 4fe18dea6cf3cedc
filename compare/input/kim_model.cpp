#include "compare/input/kim_model.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <sstream>
#include <vector>

#include "compare/base/errors.hpp"
#include "compare/base/nearest.hpp"
#include "compare/base/paths.hpp"

namespace validate {
namespace {

namespace fs = std::filesystem;

struct Collection {
  bool simulator;
  const char *variable, *folder, *library;
};
constexpr Collection collections[] = {
    {false, "KIM_API_PORTABLE_MODELS_DIR", "portable-models", "libkim-api-portable-model.so"},
    {true, "KIM_API_SIMULATOR_MODELS_DIR", "simulator-models", "libkim-api-simulator-model.so"}};

std::vector<fs::path> folders_of(const Collection& collection) {
  std::vector<fs::path> folders;
  if (const char* from_environment = std::getenv(collection.variable)) {
    std::istringstream list(from_environment);
    for (std::string folder; std::getline(list, folder, ':');) folders.emplace_back(folder);
  }
  folders.push_back(fs::path(KIM_COLLECTIONS_DIR) / collection.folder);  // set by CMake
  return folders;
}

std::vector<std::string> installed_models() {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const Collection& collection : collections)
    for (const fs::path& folder : folders_of(collection))
      for (const auto& entry : fs::directory_iterator(folder, ignored))
        names.push_back(entry.path().filename().string());
  return names;
}

}  // namespace

std::optional<KimModel> find_kim_model(const std::string& name) {
  for (const Collection& collection : collections)
    for (const fs::path& folder : folders_of(collection))
      if (const fs::path library = folder / name / collection.library; is_there(library))
        return KimModel{name, collection.simulator, library};
  return std::nullopt;
}

bool is_kim_name(std::string_view name) {
  const auto allowed = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  return !name.empty() && std::all_of(name.begin(), name.end(), allowed);
}

KimModel require_kim_model(const std::string& name, std::string_view label) {
  if (!is_kim_name(name))
    throw bad_input("{}: '{}' is not the name of an OpenKIM model: letters, digits and _ alone", label, name);
  if (const auto model = find_kim_model(name)) return *model;
  const auto names = installed_models();
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  throw bad_input("{}: the OpenKIM model '{}' is not installed ({}){}", label, name,
                  names.empty()
                      ? "there are none: the Debian package openkim-models brings them, bootstrap.sh --with-kim"
                      : fmt::format("{} others are", names.size()),
                  did_you_mean(name, candidates));
}

}  // namespace validate
