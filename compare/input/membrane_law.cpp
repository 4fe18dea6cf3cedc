#include "compare/input/membrane_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <stdexcept>

#include "compare/base/errors.hpp"

namespace validate {
namespace {

const std::vector<membrane::LawEntry>& entries() {
  static const std::vector<membrane::LawEntry> all = membrane::laws_by_name();
  return all;
}

const membrane::LawEntry& entry_of(const MembraneLaw& law) {
  const auto found = std::ranges::find(entries(), std::string_view(law.name), &membrane::LawEntry::name);
  if (found == entries().end())
    throw bad_input("law: '{}' is not known; allowed: {}", law.name, fmt::join(law_names(), ", "));
  return *found;
}

/// What the constants of the sheet say already.
bool is_of_the_sheet(const membrane::LawParameter& p) {
  return p.name == membrane::Eh_parameter.name || p.name == membrane::nu_parameter.name;
}

/// "third_order" as keys are written: "third-order".
std::string key_of(const membrane::LawParameter& p) {
  std::string name(p.name);
  std::ranges::replace(name, '_', '-');
  return name;
}

std::string with_unit(const membrane::LawParameter& p) {
  return p.unit.empty() ? key_of(p) : fmt::format("{} in {}", key_of(p), p.unit);
}

/// The keys that are a law's, with their units, for messages.
std::string keys_of(const membrane::LawEntry& entry) {
  std::vector<std::string> names;
  for (const membrane::LawParameter& p : entry.parameters)
    if (!is_of_the_sheet(p)) names.push_back(with_unit(p));
  return names.empty() ? "none beside E, thickness and nu" : fmt::format("{}", fmt::join(names, ", "));
}

std::vector<Field> made_keys() {
  static std::deque<std::string> texts;  // what the fields' views look at
  std::vector<Field> keys;
  for (const membrane::LawEntry& entry : entries())
    for (const membrane::LawParameter& p : entry.parameters) {
      const std::string name = key_of(p);
      if (is_of_the_sheet(p) || std::ranges::find(keys, std::string_view(name), &Field::name) != keys.end()) continue;
      const std::string_view kept = texts.emplace_back(name);
      const std::string_view meaning = texts.emplace_back(fmt::format("of law {}: {}", entry.name, p.meaning));
      keys.push_back(Field{kept, p.unit, meaning, any_number(), "membrane"}.at_top_too());
    }
  return keys;
}

}  // namespace

std::span<const std::string_view> law_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> all;
    for (const membrane::LawEntry& entry : entries()) all.push_back(entry.name);
    return all;
  }();
  return names;
}

const std::vector<Field>& law_keys() {
  static const std::vector<Field> keys = made_keys();
  return keys;
}

std::string in_words(const MembraneLaw& law) {
  std::string text = law.name;
  for (std::size_t i = 0; i < law_keys().size(); ++i)
    if (const auto& value = law.parameters[i])
      text += fmt::format(", {} = {:.6g}{}{}", law_keys()[i].name, *value, law_keys()[i].unit.empty() ? "" : " ",
                          law_keys()[i].unit);
  return text;
}

membrane::Law law_of(const MembraneLaw& law, double Eh_eV_per_A2, double nu, const Origins& origins) {
  const membrane::LawEntry& entry = entry_of(law);
  const auto value_of = [&](std::string_view key) {
    const auto at = std::ranges::find(law_keys(), key, &Field::name);
    return law.parameters[static_cast<std::size_t>(at - law_keys().begin())];
  };
  for (const Field& field : law_keys()) {
    const auto is_its = [&](const membrane::LawParameter& p) { return key_of(p) == field.name; };
    if (value_of(field.name) && std::ranges::none_of(entry.parameters, is_its))
      throw bad_input("{}: the law '{}' has no such parameter; it has {}", label_of(origins, field.name), law.name,
                      keys_of(entry));
  }
  membrane::LawValues values{{std::string(membrane::Eh_parameter.name), Eh_eV_per_A2},
                             {std::string(membrane::nu_parameter.name), nu}};
  for (const membrane::LawParameter& p : entry.parameters) {
    if (is_of_the_sheet(p)) continue;
    const std::optional<double> value = value_of(key_of(p));
    if (value)
      values.emplace(p.name, *value);
    else if (!p.usual)
      throw bad_input("{}: the law '{}' needs {}: {}", label_of(origins, "law"), law.name, with_unit(p), p.meaning);
  }
  try {
    return membrane::make_law(law.name, values);
  } catch (const std::invalid_argument& refused) {
    throw bad_input("{}: '{}' is not possible with these constants: {}", label_of(origins, "law"), law.name,
                    refused.what());
  }
}

}  // namespace validate
