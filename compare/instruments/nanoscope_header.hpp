// The header of a NanoScope file: sections of keys.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace validate {

/// A section such as "Ciao force image list"; keys without the backslash and, of CIAO parameters, without "@2:".
struct NanoscopeSection {
  std::string title;  ///< in lower case
  std::map<std::string, std::string, std::less<>> keys;
};

/// "V [Sens. DeflSens] (0.000375 V/LSB) 24.576 V" taken apart.
struct NanoscopeValue {
  std::string reference;  ///< Sens. DeflSens
  std::optional<double> hard, soft;
  std::string unit;  ///< of the soft value
};

/// Sections up to "\*File list end". Throws Error (bad input), which `label` starts, where the end is missing.
std::vector<NanoscopeSection> nanoscope_sections(std::string_view bytes, const std::string& label);

NanoscopeValue nanoscope_value(std::string_view text);

/// The first value of a key in any section; nothing where there is none.
std::optional<std::string> nanoscope_find(const std::vector<NanoscopeSection>& sections, std::string_view key);

}  // namespace validate
