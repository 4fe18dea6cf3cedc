// Java properties: the headers of JPK's files.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace validate {

/// Keys and values of one header. Values are what the escapes stand for, in UTF-8.
class Properties {
 public:
  Properties() = default;

  /// Reads a text in Latin-1. Throws Error (bad input), which `label` starts, for a line without '='.
  Properties(std::string_view text, const std::string& label);

  /// Null where there is no such key.
  const std::string* find(std::string_view key) const;
  std::string text(std::string_view key) const;  ///< empty where there is none

  /// Nothing where there is no such key, or NaN. Throws Error (bad input) for what is not a number.
  std::optional<double> number(std::string_view key) const;
  /// The same, from 0 to 2^31 - 1.
  std::optional<int> count(std::string_view key) const;

  /// References of the form `PREFIX.GROUP.*=J`, GROUP being lcd-info or force-segment-header-info, get every key
  /// `GROUP.J.REST` of the shared header as `PREFIX.REST`; keys of one's own stay. Throws Error (bad input) for a
  /// reference that leads nowhere.
  void resolve(const Properties& shared);

  bool empty() const { return values_.empty(); }

 private:
  std::map<std::string, std::string, std::less<>> values_;
  std::string label_;
};

}  // namespace validate
