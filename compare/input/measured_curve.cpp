#include "compare/input/measured_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <sstream>
#include <string_view>

#include "compare/base/describe.hpp"
#include "compare/base/errors.hpp"
#include "compare/base/nearest.hpp"
#include "compare/base/read_file.hpp"
#include "compare/base/units.hpp"

namespace validate {
namespace {

std::string trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\"";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(blanks) - first + 1));
}

struct Line {
  int number;
  std::vector<std::string> cells;
};

std::vector<std::string> split(const std::string& line, char separator) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, separator);) cells.push_back(trimmed(cell));
  if (line.ends_with(separator)) cells.emplace_back();
  return cells;
}

char separator_of(const std::string& header) {
  for (const char c : {'\t', ';', ','})
    if (header.find(c) != std::string::npos) return c;
  return ',';
}

/// One of the unit in base units, if the text is a unit of that quantity.
std::optional<double> unit_in_base(std::string text, std::string_view base) {
  for (auto at = text.find("_per_"); at != std::string::npos; at = text.find("_per_")) text.replace(at, 5, 1, '/');
  if (text.empty()) return std::nullopt;
  try {
    return parse_quantity("1 " + text, base, "");
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// A header cell taken apart.
struct Heading {
  std::string cell, name;
  std::optional<double> factor;  ///< to base units; nothing without a known unit
};

Heading heading(const std::string& cell, std::string_view base) {
  for (const auto& [open, close] : {std::pair{'(', ')'}, {'[', ']'}}) {
    const auto from = cell.find(open), to = cell.rfind(close);
    if (from == std::string::npos || to == std::string::npos || to < from) continue;
    return {cell, trimmed(cell.substr(0, from)), unit_in_base(trimmed(cell.substr(from + 1, to - from - 1)), base)};
  }
  for (const char mark : {'_', ' ', '/'}) {
    for (auto at = cell.find(mark); at != std::string::npos; at = cell.find(mark, at + 1))
      if (const auto factor = unit_in_base(trimmed(cell.substr(at + 1)), base))
        return {cell, trimmed(cell.substr(0, at)), factor};
  }
  return {cell, cell, std::nullopt};
}

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// What a column is for: its names, unit and the flag that chooses it.
struct Purpose {
  std::string_view flag, base, example;
  std::array<std::string_view, 4> names;
  bool needs_unit = false;  ///< found by its name only where the unit fits, too
};

constexpr Purpose depth_column{
    "--depth-column", unit::length, "depth_nm", {"depth", "indentation", "displacement", "deflection"}};
constexpr Purpose height_column{"--depth-column", unit::length, "z_nm", {"height", "piezo", "z", ""}};
constexpr Purpose sigma_depth_column{
    "--sigma-depth-column", unit::length, "sigma_depth_nm", {"sigma_depth", "depth_error", "sigma depth", ""}, true};
constexpr Purpose force_column{"--force-column", unit::force, "force_nN", {"force", "load", "f", ""}};
constexpr Purpose sigma_column{"--sigma-column", unit::force, "sigma_nN", {"sigma", "error", "stddev", ""}, true};

class Table {
 public:
  Table(const std::filesystem::path& file, const std::string& text) : file_(file) {
    std::istringstream in(text);
    int number = 0;
    char separator = ',';
    for (std::string line; std::getline(in, line);) {
      ++number;
      const std::string content = trimmed(line);
      if (content.empty()) continue;
      if (content.front() == '#') {
        remark(content);
      } else if (header_.cells.empty()) {
        separator = separator_of(content);
        header_ = {number, split(content, separator)};
      } else {
        rows_.push_back({number, split(content, separator)});
      }
    }
    if (header_.cells.empty())
      throw bad_input("{}: the file is empty; expected a header such as depth_nm,force_nN", file.string());
  }

  const std::map<std::string, std::string>& remarks() const { return remarks_; }

  /// Index of a column, or nothing where none was asked for and none has a fitting name.
  std::optional<std::size_t> find(const Purpose& purpose, const std::string& choice) const {
    if (!choice.empty()) return chosen(purpose, choice);
    for (std::size_t i = 0; i < header_.cells.size(); ++i) {
      const Heading head = heading(header_.cells[i], purpose.base);
      const std::string name = lower(head.name);
      if (purpose.needs_unit && !head.factor) continue;
      if (std::ranges::any_of(purpose.names, [&](std::string_view n) {
            return !n.empty() && (name == n || (n.size() > 1 && name.starts_with(n)));
          }))
        return i;
    }
    return std::nullopt;
  }

  std::size_t need(const Purpose& purpose, const std::string& choice) const {
    if (const auto index = find(purpose, choice)) return *index;
    throw bad_input("{}:{}: no column for {} among: {}; name it like {}, or choose one with {}", file_.string(),
                    header_.number, purpose.names[0], fmt::join(header_.cells, ", "), purpose.example, purpose.flag);
  }

  std::vector<double> column(std::size_t index, const Purpose& purpose) const {
    const Heading head = heading(header_.cells[index], purpose.base);
    if (!head.factor)
      throw bad_input("{}:{}: column '{}' has no unit that a {} can have; write it like {}", file_.string(),
                      header_.number, head.cell, quantity_of(purpose.base).name, purpose.example);
    std::vector<double> values;
    for (const Line& row : rows_) values.push_back(*head.factor * number(row, index));
    return values;
  }

  const std::string& name(std::size_t index) const { return header_.cells[index]; }

 private:
  void remark(const std::string& line) {
    const auto colon = line.find(':');
    if (colon != std::string::npos)
      remarks_[lower(trimmed(line.substr(1, colon - 1)))] = trimmed(line.substr(colon + 1));
  }

  std::size_t chosen(const Purpose& purpose, const std::string& choice) const {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(choice.data(), choice.data() + choice.size(), index);
    if (error == std::errc{} && end == choice.data() + choice.size()) {
      if (index >= 1 && index <= header_.cells.size()) return index - 1;
      throw bad_input("{}: there is no column {} in {}; it has {}", purpose.flag, choice, file_.string(),
                      header_.cells.size());
    }
    for (std::size_t i = 0; i < header_.cells.size(); ++i)
      if (header_.cells[i] == choice || heading(header_.cells[i], purpose.base).name == choice) return i;
    const std::vector<std::string_view> names(header_.cells.begin(), header_.cells.end());
    throw bad_input("{}: no column '{}' in {}; it has {}{}", purpose.flag, choice, file_.string(),
                    fmt::join(header_.cells, ", "), did_you_mean(choice, names));
  }

  double number(const Line& row, std::size_t index) const {
    if (row.cells.size() != header_.cells.size())
      throw bad_input("{}:{}: {} cells where the header has {}", file_.string(), row.number, row.cells.size(),
                      header_.cells.size());
    const std::string& cell = row.cells[index];
    double value = 0;
    const char* const first = cell.data() + (cell.starts_with('+') ? 1 : 0);
    const auto [end, error] = std::from_chars(first, cell.data() + cell.size(), value);
    if (error != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value))
      throw bad_input("{}:{}: '{}' in column '{}' is not a number", file_.string(), row.number, cell,
                      header_.cells[index]);
    return value;
  }

  std::filesystem::path file_;
  Line header_{0, {}};
  std::vector<Line> rows_;
  std::map<std::string, std::string> remarks_;
};

}  // namespace

MeasuredCurve read_measured(const std::filesystem::path& file, const ColumnChoice& choice) {
  const Table table(file, read_file(file));
  MeasuredCurve curve;
  curve.file = file;
  curve.remarks = table.remarks();
  const auto height =
      choice.depth.empty() && !table.find(depth_column, "") ? table.find(height_column, "") : std::nullopt;
  curve.depth_from_height = height.has_value();
  const std::size_t depth = height ? *height : table.need(depth_column, choice.depth),
                    force = table.need(force_column, choice.force);
  curve.depth_A = table.column(depth, depth_column);
  curve.force_eV_per_A = table.column(force, force_column);
  curve.depth_column = table.name(depth);
  curve.force_column = table.name(force);
  if (const auto sigma = table.find(sigma_column, choice.sigma)) {
    curve.sigma_eV_per_A = table.column(*sigma, sigma_column);
    curve.sigma_column = table.name(*sigma);
    if (!std::ranges::all_of(curve.sigma_eV_per_A, [](double s) { return s > 0; }))
      throw bad_input("{}: column '{}' holds a standard deviation that is not > 0", file.string(), curve.sigma_column);
  }
  if (const auto sigma = table.find(sigma_depth_column, ""))
    curve.sigma_depth_A = table.column(*sigma, sigma_depth_column);
  return curve;
}

}  // namespace validate
