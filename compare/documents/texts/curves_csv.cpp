#include "compare/documents/texts/curves_csv.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "compare/base/file.hpp"
#include "compare/base/keys.hpp"
#include "compare/base/walk.hpp"

namespace validate {

namespace {

struct NamedColumn {
  std::string key, unit, meaning;
};

std::string cell(double value) { return std::isfinite(value) ? fmt::format("{}", value) : std::string(); }
std::string cell(int value) { return fmt::format("{}", value); }
std::string cell(bool value) { return value ? "1" : "0"; }
std::string cell(const std::string& value) { return value; }
template <Worded Enum>
std::string cell(Enum value) {
  return std::string(to_string(value));
}
template <class T>
std::string cell(const std::optional<T>& value) {
  return value ? cell(*value) : std::string();
}

template <class T>
inline constexpr bool is_cell = std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_same_v<T, std::string>;
template <class T>
inline constexpr bool is_cell<std::optional<T>> = is_cell<T>;

/// Calls column(field, values) for each column of a run and value(field, value) for each single value, those of its
/// part among them.
template <class OnColumn, class OnValue>
struct Parts {
  OnColumn column;
  OnValue value;

  template <class T>
  void operator()(const Column& field, const std::vector<T>& values) const {
    column(field, values);
  }
  template <Variant Part>
  void operator()(const Field&, const Part& part) const {
    std::visit([this](const auto& members) { describe_with_twins(members, *this); }, part);
  }
  template <class T>
  void operator()(const Field& field, const T& one) const {
    if constexpr (is_cell<T>) value(field, one);
  }
};
template <class OnColumn, class OnValue>
Parts(OnColumn, OnValue) -> Parts<OnColumn, OnValue>;

/// Calls emit(field, cells) for each column of a run; forces on the tip also in nN.
template <class Emit>
void columns_of(const Run& run, Emit&& emit) {
  const auto on_column = [&](const Column& field, const auto& values) {
    std::vector<std::string> cells;
    for (const auto& value : values) cells.push_back(cell(value));
    emit(field, cells);
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(values)>, std::vector<double>>) {
      if (&values != &run.force_eV_per_A) return;
      for (std::size_t i = 0; i < values.size(); ++i) cells[i] = cell(values[i] * nN_per_eV_per_A);
      emit(in_unit(field, unit::nanonewton), cells);
    }
  };
  describe(run, Parts{on_column, [](const Field&, const auto&) {}});
}

/// The columns of every part, each once; those that no run has are left out where they may lack.
std::vector<NamedColumn> all_columns(const std::vector<Run>& runs) {
  std::vector<NamedColumn> columns;
  const auto add = [&](const Run& run, bool empty_too) {
    columns_of(run, [&](const Field& field, const std::vector<std::string>& cells) {
      const std::string name = key(field);
      if (std::ranges::find(columns, name, &NamedColumn::key) != columns.end()) return;
      if (!cells.empty() || (empty_too && !field.may_lack))
        columns.push_back({name, std::string(field.unit), std::string(field.meaning)});
    });
  };
  for (const Run& prototype : prototypes(Run{})) add(prototype, true);
  for (const Run& run : runs) add(run, false);
  return columns;
}

std::string header(const Result& result, const std::vector<NamedColumn>& columns) {
  std::string text = "# title: force-depth curves of validate\n";
  const auto comment = [&text](std::string name, std::string value) {
    std::ranges::replace(value, '\n', ' ');
    fmt::format_to(std::back_inserter(text), "# {}: {}\n", name, value);
  };
  comment("version", result.provenance.version);
  comment("command_line", result.provenance.command_line);
  comment("potential", result.resolved.potential);
  for (std::size_t i = 0; i < result.runs.size(); ++i) {
    const auto on_value = [&](const Field& field, const auto& value) {
      comment(fmt::format("run.{}.{}", i, key(field)), cell(value));
    };
    describe_with_twins(result.runs[i], Parts{[](const Column&, const auto&) {}, on_value});
  }
  for (const NamedColumn& column : columns) {
    comment("column." + column.key, column.meaning + (column.unit.empty() ? "" : " (" + column.unit + ")"));
  }
  return text;
}

}  // namespace

std::string curves_csv(const Result& result) {
  const std::vector<NamedColumn> columns = all_columns(result.runs);
  std::string text = header(result, columns) + "run,model,load,constants";
  for (const NamedColumn& column : columns) text += "," + column.key;
  text += "\n";

  for (std::size_t r = 0; r < result.runs.size(); ++r) {
    const Run& run = result.runs[r];
    std::vector<std::vector<std::string>> cells(columns.size());
    columns_of(run, [&](const Field& field, const std::vector<std::string>& values) {
      const auto column = std::ranges::find(columns, key(field), &NamedColumn::key);
      if (column != columns.end()) cells[static_cast<std::size_t>(column - columns.begin())] = values;
    });
    for (std::size_t i = 0; i < run.depth_A.size(); ++i) {
      fmt::format_to(std::back_inserter(text), "{},{},{},{}", r, to_string(run.model), to_string(run.load),
                     cell(run.constants));
      for (const auto& values : cells) text += "," + (i < values.size() ? values[i] : std::string());
      text += "\n";
    }
  }
  return text;
}

void write_curves(const Result& result, const std::filesystem::path& folder) {
  write_file(folder / "curves.csv", curves_csv(result));
}

}  // namespace validate
