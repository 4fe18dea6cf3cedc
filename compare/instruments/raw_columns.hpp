// Groups of an HDF5 file as bare names, texts and numbers, and the way to hand them from process to process.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace validate {

struct RawColumn {
  std::string name, unit;
  std::vector<double> values;
};

struct RawGroup {
  std::string name;
  std::vector<std::pair<std::string, std::variant<double, std::string>>> attributes;
  std::vector<RawColumn> columns;
};

std::string packed(const std::vector<RawGroup>& groups);

/// Throws std::logic_error where the text is not what packed() makes.
std::vector<RawGroup> unpacked(std::string_view bytes);

}  // namespace validate
