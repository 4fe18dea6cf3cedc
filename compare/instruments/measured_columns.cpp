#include "compare/instruments/measured_columns.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "compare/base/errors.hpp"
#include "compare/base/nearest.hpp"
#include "compare/instruments/headings.hpp"
#include "compare/instruments/text.hpp"

namespace validate {
namespace {

/// What a column is for: the flag that chooses it, the unit it must have, how it is named in a table.
struct Purpose {
  std::string_view name, flag, quantity, unit, example;
};
constexpr Purpose depth_purpose{"depth", "--depth-column", "length", "m", "depth_nm"};
constexpr Purpose force_purpose{"force", "--force-column", "force", "N", "force_nN"};
constexpr Purpose sigma_purpose{"sigma", "--sigma-column", "force", "N", "sigma_nN"};
constexpr Purpose sigma_depth_purpose{"sigma_depth", "", "length", "m", "sigma_depth_nm"};

/// A column by its name in the file, or by that of a recording.
struct Named {
  std::string name;
  RecordedColumn column;
};

std::vector<Named> all_columns(const Recording& recording) {
  std::vector<Named> columns;
  describe(recording.columns, [&](const Field& field, const std::optional<RecordedColumn>& column) {
    if (column) columns.push_back({column->heading.empty() ? std::string(field.name) : column->heading, *column});
  });
  for (const OtherColumn& other : recording.other_columns)
    columns.push_back({std::string(without_mark(other.name)), {other.unit, other.values, other.name}});
  return columns;
}

std::vector<std::string> names_of(const Recording& recording) {
  if (!recording.headings.empty()) return recording.headings;
  std::vector<std::string> names;
  for (const Named& one : all_columns(recording)) names.push_back(one.name);
  return names;
}

std::string place_of_names(const Recording& recording) {
  return recording.header_line > 0 ? fmt::format("{}:{}", recording.file, recording.header_line) : recording.file;
}

RecordedColumn with_unit(const Recording& recording, const Named& one, const Purpose& purpose) {
  if (one.column.unit == purpose.unit) return one.column;
  throw bad_input("{}: column '{}' has no unit that a {} can have; write it like {}", place_of_names(recording),
                  printable(one.name), purpose.quantity, purpose.example);
}

RecordedColumn chosen(const Recording& recording, const Purpose& purpose, const std::string& choice) {
  const std::vector<std::string> names = names_of(recording);
  std::string name = choice;
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(choice.data(), choice.data() + choice.size(), number);
  if (error == std::errc{} && end == choice.data() + choice.size()) {
    if (number < 1 || number > names.size())
      throw bad_input("{}: there is no column {} in {}; it has {}", purpose.flag, choice, recording.file, names.size());
    name = names[number - 1];
  }
  for (const Named& one : all_columns(recording))
    if (one.name == name || heading_of(one.name).name == name) return with_unit(recording, one, purpose);
  const std::vector<std::string_view> views(names.begin(), names.end());
  throw bad_input("{}: no column '{}' in {}; it has {}{}", purpose.flag, choice, recording.file,
                  printable(fmt::format("{}", fmt::join(names, ", "))), did_you_mean(choice, views));
}

/// Of the other columns one with such a name and unit, or with such a name alone where it must be there.
std::optional<Named> other(const Recording& recording, std::initializer_list<std::string_view> beginnings,
                           std::string_view unit) {
  for (const OtherColumn& one : recording.other_columns) {
    const std::string name = lower_case(one.name);
    for (const std::string_view beginning : beginnings)
      if (name.starts_with(beginning) && (unit.empty() || one.unit == unit))
        return Named{std::string(without_mark(one.name)), {one.unit, one.values, one.name}};
  }
  return std::nullopt;
}

[[noreturn]] void no_column(const Recording& recording, const Purpose& purpose) {
  throw bad_input("{}: no column for {} among: {}; name it like {}, or choose one with {}", place_of_names(recording),
                  purpose.name, printable(fmt::format("{}", fmt::join(names_of(recording), ", "))), purpose.example,
                  purpose.flag);
}

RecordedColumn force_of(const Recording& recording) {
  const RecordedColumns& c = recording.columns;
  if (c.force) return *c.force;
  if (const auto found = other(recording, {"force", "load"}, "")) return with_unit(recording, *found, force_purpose);
  if (c.deflection)
    throw bad_input("{}: there is a deflection in {} and no force; {} makes one of it", recording.file,
                    c.deflection->unit,
                    c.deflection->unit == "m" ? "--spring-constant" : "--spring-constant with --sensitivity");
  no_column(recording, force_purpose);
}

RecordedColumn depth_of(const Recording& recording, DepthSource& source) {
  const RecordedColumns& c = recording.columns;
  source = DepthSource::depth;
  if (c.depth) return *c.depth;
  const bool heights = c.height_measured || c.height_piezo || c.tip_position;
  if (c.deflection && c.deflection->unit == "m" && !heights) return *c.deflection;  // the sheet's
  source = c.height_measured || c.height_piezo ? DepthSource::height : DepthSource::tip;
  if (c.height_measured) return *c.height_measured;
  if (c.height_piezo) return *c.height_piezo;
  if (c.tip_position) return *c.tip_position;
  if (const auto found =
          other(recording, {"depth", "indentation", "displacement", "deflection", "height", "piezo"}, ""))
    return with_unit(recording, *found, depth_purpose);
  no_column(recording, depth_purpose);
}

}  // namespace

MeasuredColumns measured_columns(const Recording& recording, const ColumnChoice& choice) {
  MeasuredColumns columns;
  columns.depth =
      choice.depth.empty() ? depth_of(recording, columns.source) : chosen(recording, depth_purpose, choice.depth);
  columns.force = choice.force.empty() ? force_of(recording) : chosen(recording, force_purpose, choice.force);
  if (!choice.sigma.empty()) {
    columns.sigma = chosen(recording, sigma_purpose, choice.sigma);
  } else if (const auto found = other(recording, {"sigma", "error", "stddev"}, sigma_purpose.unit)) {
    columns.sigma = found->column;
  }
  if (columns.sigma) columns.sigma_name = columns.sigma->heading;
  if (const auto found = other(recording, {"sigma_depth", "sigma depth", "depth_error"}, sigma_depth_purpose.unit))
    columns.sigma_depth = found->column;
  return columns;
}

}  // namespace validate
