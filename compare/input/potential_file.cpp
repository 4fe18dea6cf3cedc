#include "compare/input/potential_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "compare/base/describe.hpp"
#include "compare/base/errors.hpp"
#include "compare/base/nearest.hpp"
#include "compare/base/paths.hpp"
#include "compare/base/read_file.hpp"
#include "compare/base/sha256.hpp"
#include "compare/base/toml_file.hpp"
#include "compare/input/kim_model.hpp"

namespace validate {

namespace fs = std::filesystem;

namespace {

struct Keys {
  std::string description, pair_style, file, declares, parameters_sha256, switch_parameter, kim_model, citation;
  std::vector<std::string> pair_coeff;
  double mass = 12.011;
  double interaction_range_A = 0;
  double artefact_bond_A = 1.70;
};

template <class Self, class Visitor>
requires SameStruct<Self, Keys>
void describe(Self& k, Visitor&& visit) {
  visit(Field{"description", {}, "what the potential is, one line"}, k.description);
  visit(Field{"pair_style", {}, "LAMMPS pair style with its arguments"}, k.pair_style);
  visit(Field{"pair_coeff", {}, "pair_coeff lines; {file} stands for the parameter file"}, k.pair_coeff);
  visit(Field{"file", {}, "parameter file"}, k.file);
  visit(Field{"declares", {}, "words that the parameter file must hold outside comments"}, k.declares);
  visit(Field{"parameters_sha256", {}, "SHA-256 of the file's words outside comments"}, k.parameters_sha256);
  visit(Field{"switch_parameter", {}, "parameter that --switch-length moves"}, k.switch_parameter);
  visit(Field{"mass", {}, "mass of a carbon atom, g/mol", positive()}, k.mass);
  visit(Field{"interaction_range", unit::length, "how far an atom changes forces", from_above_to(0, 50)},
        k.interaction_range_A);
  visit(Field{"artefact_bond", unit::length, "bond length from which forces are an artefact", positive()},
        k.artefact_bond_A);
  visit(Field{"citation", {}, "paper, with DOI"}, k.citation);
  visit(Field{"model", {}, "OpenKIM model, in place of style, coefficients and file", {}, "kim"}, k.kim_model);
}

fs::path find_description(std::string_view name_or_path, const fs::path& folder, std::string_view label) {
  if (const fs::path named = folder / fmt::format("{}.toml", name_or_path);
      !name_or_path.ends_with(".toml") && !name_or_path.starts_with('/') && is_there(named))
    return named;
  if (is_path(name_or_path)) return fs::absolute(name_or_path).lexically_normal();
  const auto names = available_potentials(folder);
  if (std::find(names.begin(), names.end(), name_or_path) != names.end()) {
    return folder / fmt::format("{}.toml", name_or_path);
  }
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  throw bad_input("{}: unknown potential '{}'; available: {}, or a path to a TOML file{}", label, name_or_path,
                  fmt::join(names, ", "), did_you_mean(name_or_path, candidates));
}

fs::path find_parameters(const std::string& file, const fs::path& toml, std::string_view label) {
  if (file.find('/') != std::string::npos) return fs::absolute(toml.parent_path() / file).lexically_normal();
  const auto places = places_for_parameters(toml);
  for (const fs::path& place : places) {
    if (is_there(place / file)) return fs::absolute(place / file).lexically_normal();
  }
  std::vector<std::string> searched;
  for (const fs::path& place : places) searched.push_back(place.string());
  throw bad_input("{}: there is no parameter file '{}' in {}", label, file, fmt::join(searched, ", "));
}

// The text outside comments, its words separated by single blanks, each line between blanks.
std::string words_of(const std::string& content) {
  std::istringstream lines(content);
  std::string words = " ";
  for (std::string line; std::getline(lines, line);) {
    std::istringstream in(line.substr(0, line.find('#')));
    for (std::string word; in >> word;) words += word + " ";
  }
  return words;
}

void check_parameters(const std::string& content, const Keys& keys, const fs::path& file, std::string_view label) {
  const std::string words = words_of(content);
  if (words == " ") throw bad_input("{}: the parameter file '{}' holds no parameters", label, file.string());
  if (words.find(fmt::format(" {} ", keys.declares)) == std::string::npos && !keys.declares.empty()) {
    throw bad_input("{}: the parameter file '{}' does not hold '{}', so it does not describe carbon for '{}'", label,
                    file.string(), keys.declares, keys.pair_style);
  }
}

/// AIREBO's and REBO's files have one layout and differ in numbers; their comments say which is which.
void check_look_alike(const std::string& content, const Keys& keys, const fs::path& file, std::string_view label) {
  const std::string style = keys.pair_style.substr(0, keys.pair_style.find(' '));
  const bool is_rebo = content.find("REBO2") != std::string::npos;
  const bool is_airebo = !is_rebo && content.find("AIREBO") != std::string::npos;
  if ((style == "rebo" && is_airebo) || (style == "airebo" && is_rebo))
    throw bad_input("{}: '{}' holds the parameters of {}, not of '{}'", label, file.string(),
                    is_rebo ? "REBO" : "AIREBO", style);
}

void check_digest(const std::string& content, const Keys& keys, PotentialFile& result) {
  if (keys.parameters_sha256.empty() || sha256(words_of(content)) == keys.parameters_sha256) return;
  result.warnings.push_back(
      fmt::format("the parameters in '{}' are not those that '{}' was written for: edited, cut short or of another "
                  "LAMMPS version; cards and references may not hold",
                  result.potential.file, result.toml.string()));
}

/// Portable models are a pair style; simulator models set one themselves.
void use_kim_model(const Keys& keys, std::string_view label, PotentialFile& result) {
  const KimModel model = require_kim_model(keys.kim_model, label);
  result.sha256 = sha256(read_file(model.library, label));
  if (model.simulator) {
    result.potential.kim_model = model.name;
  } else {
    result.potential.pair_style = "kim " + model.name;
    result.potential.pair_coeff = {"* * C"};
  }
}

void check_keys(const Keys& keys, const fs::path& toml) {
  const auto require = [&](bool given, std::string_view key) {
    if (!given) throw bad_input("{}: the key '{}' is missing", toml.string(), key);
  };
  if (!keys.kim_model.empty()) {
    require(keys.interaction_range_A > 0, "interaction_range");
    if (!keys.pair_style.empty() || !keys.pair_coeff.empty() || !keys.file.empty())
      throw bad_input("{}: [kim] model takes the place of pair_style, pair_coeff and file; give one or the other",
                      toml.string());
    return;
  }
  require(!keys.pair_style.empty(), "pair_style");
  require(!keys.pair_coeff.empty(), "pair_coeff");
  require(keys.interaction_range_A > 0, "interaction_range");
  const bool uses_file = std::any_of(keys.pair_coeff.begin(), keys.pair_coeff.end(),
                                     [](const std::string& line) { return line.find("{file}") != std::string::npos; });
  if (uses_file) require(!keys.file.empty(), "file");
  if (!uses_file && !keys.file.empty()) {
    throw bad_input("{}: no line of pair_coeff holds {{file}}, the place of '{}'", toml.string(), keys.file);
  }
}

/// A style may be one of several in a hybrid.
void check_code(const Keys& keys, std::string_view label, CodeInPotential code) {
  constexpr std::string_view running_code[] = {"python", "mliap"};
  std::istringstream words(keys.pair_style);
  for (std::string word, before; words >> word; before = word) {
    const std::string_view style = std::string_view(word).substr(0, word.find('/'));
    if (code == CodeInPotential::refused && std::ranges::find(running_code, style) != std::end(running_code))
      throw bad_input("{}: '{}' runs a program that the potential brings; --allow-code lets it", label, word);
    if (before == "kim" && !is_kim_name(word))
      throw bad_input("{}: '{}' is not the name of an OpenKIM model: letters, digits and _ alone", label, word);
  }
}

}  // namespace

bool is_path(std::string_view potential) {
  return potential.find('/') != std::string_view::npos || potential.ends_with(".toml");
}

std::vector<std::string> available_potentials(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<fs::path> places_for_parameters(const fs::path& toml) {
  std::vector<fs::path> places = {fs::absolute(toml).parent_path()};
  if (const char* from_environment = std::getenv("LAMMPS_POTENTIALS")) {
    std::istringstream folders(from_environment);
    for (std::string folder; std::getline(folders, folder, ':');) {
      if (!folder.empty()) places.emplace_back(folder);
    }
  }
  places.emplace_back(LAMMPS_POTENTIALS_DIR);  // set by CMake
  return places;
}

PotentialFile read_potential(std::string_view name_or_path, const fs::path& folder, std::string_view label,
                             CodeInPotential code) {
  const fs::path toml = find_description(name_or_path, folder, label);
  Keys keys;
  const Origins origins = TomlFile(toml, label).read(keys);
  check_keys(keys, toml);
  check_code(keys, label_of(origins, "pair_style"), code);

  PotentialFile result;
  result.toml = toml;
  result.potential = {.name = toml.stem().string(),
                      .pair_style = keys.pair_style,
                      .pair_coeff = keys.pair_coeff,
                      .file = {},
                      .kim_model = {},
                      .mass = keys.mass,
                      .interaction_range_A = keys.interaction_range_A,
                      .artefact_bond_A = keys.artefact_bond_A,
                      .description = keys.description,
                      .citation = keys.citation};
  result.switch_parameter = keys.switch_parameter;
  if (!keys.kim_model.empty()) use_kim_model(keys, label_of(origins, "model"), result);
  if (!keys.file.empty()) {
    const std::string file_label = label_of(origins, "file");
    const fs::path file = find_parameters(keys.file, toml, file_label);
    const std::string content = read_file(file, file_label);
    check_look_alike(content, keys, file, file_label);
    check_parameters(content, keys, file, file_label);
    result.potential.file = file.string();
    check_digest(content, keys, result);
    result.sha256 = sha256(content);
  }
  return result;
}

}  // namespace validate
