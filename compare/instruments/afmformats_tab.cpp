#include "compare/instruments/afmformats_tab.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "compare/base/errors.hpp"
#include "compare/instruments/afmformats_names.hpp"
#include "compare/instruments/assemble.hpp"
#include "compare/instruments/text.hpp"

namespace validate {
namespace {

constexpr std::string_view begin_metadata = "BEGIN METADATA", end_metadata = "END METADATA";

struct Parts {
  std::string metadata;  ///< JSON
  int metadata_line = 1;
  TextLine header{0, {}};
  std::vector<TextLine> rows;
};

Parts parts_of(std::string_view text) {
  Parts parts;
  bool inside = false;
  for (const TextLine& line : lines_of(text)) {
    if (!line.text.starts_with('#')) {
      if (!trimmed(line.text).empty()) parts.rows.push_back(line);
      continue;
    }
    const std::string_view content = trimmed(line.text.substr(1));
    if (content == begin_metadata) parts.metadata_line = line.number + 1;
    if (content == end_metadata) inside = false;
    if (inside) parts.metadata += std::string(line.text.substr(1)) + "\n";
    if (content == begin_metadata) inside = true;
    if (!content.empty() && parts.rows.empty()) parts.header = {line.number, content};
  }
  return parts;
}

void read_metadata(RecordingMetadata& m, const Parts& parts, const std::string& file) {
  const auto json = nlohmann::json::parse(parts.metadata, nullptr, false);
  if (!json.is_object())
    throw bad_input("{}:{}: the lines from BEGIN METADATA to END METADATA are no JSON object", file,
                    parts.metadata_line);
  for (const auto& [name, value] : json.items()) {
    if (value.is_number()) set_metadata(m, name, value.get<double>());
    if (value.is_string()) set_metadata(m, name, value.get<std::string>());
  }
}

/// Names of the columns. Where the line's end has been lost the first row follows the last name: that row is left out.
std::vector<std::string> names_of(const Parts& parts, Recording& recording, const std::string& file) {
  const auto cells = cells_of(parts.header.text, '\t');
  const std::size_t columns = cells_of(parts.rows.front().text, '\t').size();
  std::vector<std::string> names(cells.begin(), cells.end());
  if (names.size() == columns) return names;
  if (names.size() == 2 * columns - 1) {
    std::string& glued = names[columns - 1];
    for (std::size_t length = 1; length < glued.size(); ++length) {
      if (!number_of(std::string_view(glued).substr(length))) continue;
      glued.resize(length);
      names.resize(columns);
      recording.notes.push_back(fmt::format(
          "line {}: the first row follows the names without a line's end and is left out", parts.header.number));
      return names;
    }
  }
  throw bad_input("{}:{}: {} names of columns where the rows have {} cells", file, parts.header.number, names.size(),
                  columns);
}

std::optional<double> cell_value(std::string_view cell) {
  if (cell == "False") return 0;
  if (cell == "True") return 1;
  return number_of(cell);
}

std::string_view unit_of(std::string_view name) {
  if (name == "force") return "N";
  if (name == "time") return "s";
  return name.starts_with("height") || name == "tip position" || name == "deflection" ? "m" : "";
}

std::vector<std::vector<double>> values_of(const Parts& parts, std::size_t columns, const std::string& file) {
  std::vector<std::vector<double>> values(columns);
  for (const TextLine& line : parts.rows) {
    const auto cells = cells_of(line.text, '\t');
    if (cells.size() != columns)
      throw bad_input("{}:{}: {} cells where the other rows have {}", file, line.number, cells.size(), columns);
    for (std::size_t c = 0; c < columns; ++c) {
      const auto value = cell_value(cells[c]);
      if (!value) throw bad_input("{}:{}: '{}' is not a number", file, line.number, printable(cells[c]));
      values[c].push_back(*value);
    }
  }
  return values;
}

bool recognises_tab(const FileContent& file) {
  return !file.archive && file.bytes.starts_with("# afmformats") &&
         file.bytes.substr(0, 4096).find(begin_metadata) != std::string_view::npos;
}

std::unique_ptr<Recordings> open_tab(const FileContent& file, const Calibration& calibration) {
  const std::string text = to_utf8(file.bytes);
  const Parts parts = parts_of(text);
  if (parts.rows.empty()) throw bad_input("{}: no rows below the comments", file.name);
  Recording recording;
  recording.file = file.name;
  read_metadata(recording.metadata, parts, file.name);
  recording.metadata.format = afmformats_tab_format.name;
  const std::vector<std::string> names = names_of(parts, recording, file.name);
  std::vector<std::vector<double>> values = values_of(parts, names.size(), file.name);
  for (std::size_t c = 0; c < names.size(); ++c) {
    if (names[c] == "segment")
      recording.segments = numbered_segments(values[c], file.name);
    else if (auto* place = place_of(recording.columns, names[c]))
      *place = RecordedColumn{std::string(unit_of(names[c])), std::move(values[c])};
    else
      recording.other_columns.push_back({printable(names[c]), "", std::move(values[c])});
  }
  recording.metadata.points = static_cast<int>(parts.rows.size());
  if (recording.segments.empty()) split_at_turn(recording);
  recording.index = std::max(recording.metadata.number.value_or(0), 0);
  calibrate(recording, calibration);
  return std::make_unique<ReadyRecordings>(std::vector{std::move(recording)});
}

}  // namespace

const InstrumentFormat afmformats_tab_format = {"afmformats table", ".tab", recognises_tab, open_tab};

}  // namespace validate
