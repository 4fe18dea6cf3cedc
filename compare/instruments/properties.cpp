#include "compare/instruments/properties.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "compare/base/errors.hpp"
#include "compare/instruments/text.hpp"

namespace validate {
namespace {

/// More keys than any header has; a small shared header that is referred to again and again would make many.
constexpr std::size_t most_keys = 200000;

/// \uXXXX, \n, \: …; `at` is behind the backslash and is moved behind the escape.
void unescape(std::string_view text, std::size_t& at, std::string& into) {
  const char c = text[at++];
  if (c == 'n' || c == 't' || c == 'r' || c == 'f') {
    into += c == 'n' ? '\n' : c == 't' ? '\t' : c == 'r' ? '\r' : '\f';
  } else if (c == 'u') {
    unsigned code = 0;
    const auto digits = text.substr(at, 4);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    at += static_cast<std::size_t>(end - digits.data());
    append_utf8(into, error == std::errc{} ? code : 0xFFFDu);
  } else {
    append_utf8(into, static_cast<unsigned char>(c));
  }
}

/// Text in Latin-1 with its escapes, up to an unescaped character of `stops`.
std::string plain(std::string_view text, std::size_t& at, std::string_view stops) {
  std::string result;
  while (at < text.size() && stops.find(text[at]) == std::string_view::npos) {
    const char c = text[at++];
    if (c == '\\' && at < text.size())
      unescape(text, at, result);
    else
      append_utf8(result, static_cast<unsigned char>(c));
  }
  return result;
}

}  // namespace

Properties::Properties(std::string_view text, const std::string& label) : label_(label) {
  for (const TextLine& line : lines_of(text)) {
    const std::string_view content = trimmed(line.text);
    if (content.empty() || content.front() == '#' || content.front() == '!') continue;
    std::size_t at = 0;
    std::string key = plain(content, at, "=:");
    if (at >= content.size())
      throw bad_input("{}:{}: '{}' is no line of the form key=value", label, line.number, printable(content));
    ++at;
    std::string value = plain(content, at, "");
    values_.insert_or_assign(std::string(trimmed(key)), std::string(trimmed(value)));
    if (values_.size() > most_keys) throw bad_input("{}: more than {} keys", label, most_keys);
  }
}

const std::string* Properties::find(std::string_view key) const {
  const auto found = values_.find(key);
  return found == values_.end() ? nullptr : &found->second;
}

std::string Properties::text(std::string_view key) const {
  const std::string* value = find(key);
  return value ? *value : std::string();
}

std::optional<double> Properties::number(std::string_view key) const {
  const std::string* value = find(key);
  if (!value || value->empty()) return std::nullopt;
  const auto number = number_of(*value);
  if (!number) throw bad_input("{}: {}: '{}' is not a number", label_, key, printable(*value));
  if (!std::isfinite(*number)) return std::nullopt;
  return number;
}

std::optional<int> Properties::count(std::string_view key) const {
  const auto value = number(key);
  if (!value) return std::nullopt;
  if (!(*value >= 0 && *value <= std::numeric_limits<int>::max()) || *value != std::floor(*value))
    throw bad_input("{}: {}: '{}' is not a whole number from 0 to {}", label_, key, text(key),
                    std::numeric_limits<int>::max());
  return static_cast<int>(*value);
}

void Properties::resolve(const Properties& shared) {
  std::vector<std::pair<std::string, std::string>> added;
  for (const auto& [key, value] : values_) {
    for (const std::string_view group : {".lcd-info.*", ".force-segment-header-info.*"}) {
      if (!key.ends_with(group)) continue;
      const std::string prefix = key.substr(0, key.size() - group.size());
      const std::string from = fmt::format("{}.{}.", group.substr(1, group.size() - 3), value);
      auto at = shared.values_.lower_bound(from);
      if (at == shared.values_.end() || !at->first.starts_with(from))
        throw bad_input("{}: {}={}: the shared header has no keys {}…", label_, key, printable(value), printable(from));
      for (; at != shared.values_.end() && at->first.starts_with(from); ++at)
        added.emplace_back(prefix + "." + at->first.substr(from.size()), at->second);
      if (added.size() > most_keys) throw bad_input("{}: more than {} keys by reference", label_, most_keys);
    }
  }
  for (auto& [key, value] : added) values_.emplace(std::move(key), std::move(value));
}

}  // namespace validate
