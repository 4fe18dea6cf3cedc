#include "compare/instruments/nanoscope_header.hpp"

#include "compare/base/errors.hpp"
#include "compare/instruments/text.hpp"

namespace validate {
namespace {

constexpr std::string_view end_of_header = "\\*File list end";

/// "@4:Z scale" and "@Sens. Zsens" without what stands before the name.
std::string_view plain_key(std::string_view key) {
  if (!key.starts_with('@')) return key;
  key.remove_prefix(1);
  const auto digits = key.find_first_not_of("0123456789");
  if (digits != std::string_view::npos && digits > 0 && key[digits] == ':') key.remove_prefix(digits + 1);
  return key;
}

/// Where the key ends: behind the colon of a group number there is another.
std::size_t colon_of(std::string_view line) {
  std::size_t from = 0;
  if (line.starts_with('@')) from = line.find_first_not_of("0123456789", 1);
  if (from != std::string_view::npos && from > 1 && from < line.size() && line[from] == ':') ++from;
  return line.find(':', from == std::string_view::npos ? 0 : from);
}

}  // namespace

std::vector<NanoscopeSection> nanoscope_sections(std::string_view bytes, const std::string& label) {
  const auto end = bytes.find(end_of_header);
  if (end == std::string_view::npos) throw bad_input("{}: a NanoScope header without '{}'", label, end_of_header);
  std::vector<NanoscopeSection> sections;
  const std::string text = to_utf8(bytes.substr(0, end));
  for (const TextLine& line : lines_of(text)) {
    std::string_view content = trimmed(line.text);
    if (!content.starts_with('\\')) continue;
    content.remove_prefix(1);
    if (content.starts_with('*')) {
      sections.push_back({lower_case(content.substr(1)), {}});
      continue;
    }
    const auto colon = colon_of(content);
    if (colon == std::string_view::npos || sections.empty()) continue;
    sections.back().keys.emplace(plain_key(content.substr(0, colon)), trimmed(content.substr(colon + 1)));
  }
  return sections;
}

NanoscopeValue nanoscope_value(std::string_view text) {
  NanoscopeValue value;
  text = trimmed(text);
  if (text.starts_with("V ") || text.starts_with("C ")) text.remove_prefix(2);
  const auto between = [&text](char open, char close) -> std::string_view {
    text = trimmed(text);
    const auto end = text.find(close);
    if (!text.starts_with(open) || end == std::string_view::npos) return {};
    const std::string_view inside = text.substr(1, end - 1);
    text.remove_prefix(end + 1);
    return inside;
  };
  value.reference = std::string(between('[', ']'));
  const auto hard = cells_of(between('(', ')'), ' ');
  if (!hard.empty()) value.hard = number_of(hard.front());
  const auto soft = cells_of(text, ' ');
  if (!soft.empty()) value.soft = number_of(soft.front());
  if (soft.size() > 1) value.unit = std::string(soft[1]);
  return value;
}

std::optional<std::string> nanoscope_find(const std::vector<NanoscopeSection>& sections, std::string_view key) {
  for (const NanoscopeSection& section : sections)
    if (const auto found = section.keys.find(key); found != section.keys.end()) return found->second;
  return std::nullopt;
}

}  // namespace validate
