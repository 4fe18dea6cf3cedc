#include "compare/potential/switch_length.hpp"

#include <fmt/format.h>

#include <sstream>
#include <vector>

#include "compare/base/errors.hpp"
#include "compare/base/file.hpp"
#include "compare/base/read_file.hpp"
#include "compare/base/sha256.hpp"

namespace validate {
namespace {

struct Edit {
  std::string content, old_value;
  int places = 0;
};

/// Lines `value name …` of AIREBO's and REBO's files.
Edit with_value(const std::string& content, const std::string& name, const std::string& value) {
  Edit edit;
  std::istringstream lines(content);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string first, second;
    if (words >> first >> second && second == name) {
      line.replace(line.find(first), first.size(), value);
      edit.old_value = first;
      ++edit.places;
    }
    edit.content += line + "\n";
  }
  return edit;
}

}  // namespace

void check_switch(const PotentialFile& potential, std::string_view label) {
  if (potential.switch_parameter.empty())
    throw bad_input(
        "{}: the potential '{}' has no switch that can be moved (its description names no switch_parameter)", label,
        potential.potential.name);
}

PotentialFile with_switch_at(const PotentialFile& potential, double length_A, DocumentFolder& folder,
                             std::string_view label) {
  check_switch(potential, label);
  const std::filesystem::path original = potential.potential.file;
  const Edit edit = with_value(read_file(original, label), potential.switch_parameter, fmt::format("{}", length_A));
  if (edit.places != 1)
    throw bad_input("{}: '{}' stands {} times in '{}'; once is expected", label, potential.switch_parameter,
                    edit.places, original.string());
  const std::string copy = fmt::format("switched-{}", original.filename().string());
  write_file(folder.drafts() / copy, edit.content);
  folder.publish();
  PotentialFile moved = potential;
  moved.potential.file = (folder.path() / copy).string();
  moved.potential.artefact_bond_A = length_A;
  moved.edit = fmt::format("{} from {} to {} Å in a copy, {}, SHA-256 {}", potential.switch_parameter, edit.old_value,
                           length_A, copy, sha256(edit.content));
  return moved;
}

}  // namespace validate
