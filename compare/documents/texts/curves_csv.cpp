#include "compare/documents/texts/curves_csv.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <vector>

#include "compare/base/file.hpp"
#include "compare/results/keys.hpp"

namespace validate {

namespace {

struct Column {
  std::string key, unit, meaning;
};

std::string cell(double value) { return std::isfinite(value) ? fmt::format("{}", value) : std::string(); }
std::string cell(int value) { return fmt::format("{}", value); }
std::string cell(bool value) { return value ? "1" : "0"; }
std::string cell(const std::string& value) { return value; }
template <class Enum>
requires std::is_enum_v<Enum> std::string cell(Enum value) { return std::string(to_string(value)); }
template <class T>
std::string cell(const std::optional<T>& value) {
  return value ? cell(*value) : std::string();
}

// Calls emit(field, cells) for each column of a run; forces on the tip also in nN.
template <class Emit>
void columns_of(const Run& run, Emit&& emit) {
  describe_points(run, [&](const Field& field, const auto& values) {
    std::vector<std::string> cells;
    for (const auto& value : values) cells.push_back(cell(value));
    emit(field, cells);
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(values)>, std::vector<double>>) {
      if (&values != &run.force_eV_per_A) return;
      for (std::size_t i = 0; i < values.size(); ++i) cells[i] = cell(values[i] * nN_per_eV_per_A);
      emit(in_unit(field, nanonewton), cells);
    }
  });
}

// The columns of both models, each once.
std::vector<Column> all_columns() {
  std::vector<Column> columns;
  for (const Model model : {Model::membrane, Model::atomistic, Model::sheet}) {
    Run empty;
    empty.model = model;
    if (model == Model::sheet) empty.constants = Constants::calibrated;
    columns_of(empty, [&](const Field& field, const auto&) {
      const std::string name = key(field);
      if (std::ranges::find(columns, name, &Column::key) != columns.end()) return;
      columns.push_back({name, std::string(field.unit), std::string(field.meaning)});
    });
  }
  return columns;
}

std::string header(const Result& result, const std::vector<Column>& columns) {
  std::string text = "# title: force-depth curves of validate\n";
  const auto comment = [&text](std::string name, std::string value) {
    std::ranges::replace(value, '\n', ' ');
    fmt::format_to(std::back_inserter(text), "# {}: {}\n", name, value);
  };
  comment("version", result.provenance.version);
  comment("command_line", result.provenance.command_line);
  comment("potential", result.resolved.potential);
  for (std::size_t i = 0; i < result.runs.size(); ++i) {
    describe_with_twins(result.runs[i], [&](const Field& field, const auto& value) {
      comment(fmt::format("run.{}.{}", i, key(field)), cell(value));
    });
  }
  for (const Column& column : columns) {
    comment("column." + column.key, column.meaning + (column.unit.empty() ? "" : " (" + column.unit + ")"));
  }
  return text;
}

}  // namespace

std::string curves_csv(const Result& result) {
  const std::vector<Column> columns = all_columns();
  std::string text = header(result, columns) + "run,model,load,constants";
  for (const Column& column : columns) text += "," + column.key;
  text += "\n";

  for (std::size_t r = 0; r < result.runs.size(); ++r) {
    const Run& run = result.runs[r];
    std::vector<std::vector<std::string>> cells(columns.size());
    columns_of(run, [&](const Field& field, const std::vector<std::string>& values) {
      const auto column = std::ranges::find(columns, key(field), &Column::key);
      cells[static_cast<std::size_t>(column - columns.begin())] = values;
    });
    for (std::size_t i = 0; i < run.depth_A.size(); ++i) {
      fmt::format_to(std::back_inserter(text), "{},{},{},{}", r, to_string(run.model), run.load,
                     to_string(run.constants));
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
