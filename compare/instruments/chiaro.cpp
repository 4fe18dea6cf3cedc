#include "compare/instruments/chiaro.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "compare/base/errors.hpp"
#include "compare/instruments/assemble.hpp"
#include "compare/instruments/text.hpp"

namespace validate {
namespace {

constexpr std::string_view table_start = "Time (s)\tLoad (";

struct Parts {
  std::map<std::string, std::string, std::less<>> keys;  ///< with their units, one blank between words
  std::vector<TextLine> table;                           ///< its header first
};

std::string one_blank(std::string_view text) { return fmt::format("{}", fmt::join(cells_of(text, ' '), " ")); }

/// Several pairs of key and value on a line, parted by tabs; or "Key: value".
void add_keys(Parts& parts, std::string_view line) {
  const auto cells = cells_of(line, '\t');
  for (std::size_t i = 0; i + 1 < cells.size(); i += 2) {
    std::string key = one_blank(cells[i]);
    if (key.ends_with(':')) key.pop_back();
    parts.keys.emplace(std::move(key), cells[i + 1]);
  }
  const auto colon = line.find(':');
  if (cells.size() == 1 && colon != std::string_view::npos)
    parts.keys.emplace(one_blank(line.substr(0, colon)), trimmed(line.substr(colon + 1)));
}

Parts parts_of(std::string_view text) {
  Parts parts;
  for (const TextLine& line : lines_of(text)) {
    if (parts.table.empty() && !line.text.starts_with(table_start))
      add_keys(parts, line.text);
    else if (!trimmed(line.text).empty())
      parts.table.push_back(line);
  }
  return parts;
}

std::string text(const Parts& parts, std::string_view key) {
  const auto found = parts.keys.find(key);
  return found == parts.keys.end() ? std::string() : found->second;
}

/// The value of a key "NAME (UNIT)" in SI.
double quantity(const Parts& parts, std::string_view name) {
  for (const auto& [key, value] : parts.keys) {
    if (!key.starts_with(name) || key.size() < name.size() + 3 || key[name.size() + 1] != '(') continue;
    const auto unit = si_unit(std::string_view(key).substr(name.size() + 2, key.find(')') - name.size() - 2));
    const auto number = number_of(value);
    if (unit && number) return unit->factor * *number;
  }
  return not_known;
}

RecordingMetadata metadata_of(const Parts& parts) {
  RecordingMetadata m;
  m.format = chiaro_format.name;
  m.imaging_mode = "force-distance";
  m.feedback_mode = "contact";
  m.instrument = m.software = text(parts, "Device");
  m.software_version = text(parts, "Software version");
  m.date = text(parts, "Date");  // day and month in an order that the file does not tell
  m.time = text(parts, "Time");
  m.number = 0;
  m.session_id = m.date + "_" + m.time;
  m.curve_id = m.session_id + "_0";
  m.spring_constant_N_per_m = quantity(parts, "k");
  m.tip_radius_m = quantity(parts, "Tip radius");
  m.setpoint = quantity(parts, "Max load");
  if (m.setpoint == m.setpoint) m.setpoint_unit = "N";
  m.speed_approach_m_per_s = m.speed_retract_m_per_s = quantity(parts, "Piezo speed");
  m.position_x_m = quantity(parts, "X-position");
  m.position_y_m = quantity(parts, "Y-position");
  return m;
}

struct Column {
  std::string name;
  SiUnit unit;
  std::vector<double> values = {};
};

std::vector<Column> columns_of(const TextLine& header, const std::string& file) {
  std::vector<Column> columns;
  for (const std::string_view cell : cells_of(header.text, '\t')) {
    const auto open = cell.find(" (");
    const bool has_unit = open != std::string_view::npos && cell.ends_with(')');
    const auto unit = has_unit ? si_unit(cell.substr(open + 2, cell.size() - open - 3)) : std::nullopt;
    if (has_unit && !unit)
      throw bad_input("{}:{}: column '{}' has a unit that is not known", file, header.number, printable(cell));
    columns.push_back({lower_case(cell.substr(0, open)), unit.value_or(SiUnit{1, ""})});
  }
  return columns;
}

std::vector<Column> table_of(const Parts& parts, const std::string& file) {
  std::vector<Column> columns = columns_of(parts.table.front(), file);
  for (std::size_t i = 1; i < parts.table.size(); ++i) {
    const TextLine& line = parts.table[i];
    const auto cells = cells_of(line.text, '\t');
    if (cells.size() < columns.size())
      throw bad_input("{}:{}: {} cells where the header has {}", file, line.number, cells.size(), columns.size());
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const auto value = number_of(cells[c]);
      if (!value) throw bad_input("{}:{}: '{}' is not a number", file, line.number, printable(cells[c]));
      columns[c].values.push_back(columns[c].unit.factor * *value);
    }
  }
  return columns;
}

std::optional<RecordedColumn> column(const std::vector<Column>& columns, std::string_view name, double factor) {
  const auto found = std::ranges::find(columns, name, &Column::name);
  if (found == columns.end()) return std::nullopt;
  RecordedColumn result{found->unit.unit, found->values};
  for (double& value : result.values) value *= factor;
  return result;
}

/// The piezo grows towards the sample; heights fall. The tip is at −piezo + cantilever.
void place_columns(Recording& recording, const std::vector<Column>& table) {
  RecordedColumns& columns = recording.columns;
  columns.time = column(table, "time", 1);
  columns.force = column(table, "load", 1);
  columns.height_measured = column(table, "indentation", -1);
  columns.height_piezo = column(table, "piezo", -1);
  columns.deflection = column(table, "cantilever", 1);
  if (columns.height_piezo && columns.deflection) {
    columns.tip_position = columns.height_piezo;
    for (std::size_t i = 0; i < columns.tip_position->values.size(); ++i)
      columns.tip_position->values[i] += columns.deflection->values[i];
  }
  if (const auto other = column(table, "auxiliary", 1))
    recording.other_columns.push_back({"auxiliary", other->unit, other->values});
}

bool recognises_chiaro(const FileContent& file) {
  return !file.archive && is_text(file.bytes) &&
         file.bytes.substr(0, 20000).find(table_start) != std::string_view::npos;
}

std::unique_ptr<Recordings> open_chiaro(const FileContent& file, const Calibration& calibration) {
  const std::string text = to_utf8(file.bytes);
  const Parts parts = parts_of(text);
  if (parts.table.size() < 2) throw bad_input("{}: no rows below the line '{}…'", file.name, printable(table_start));
  Recording recording;
  recording.file = file.name;
  recording.metadata = metadata_of(parts);
  place_columns(recording, table_of(parts, file.name));
  const auto& force = recording.columns.force;
  if (!force) throw bad_input("{}: no column Load in the table", file.name);
  recording.metadata.points = static_cast<int>(force->values.size());
  recording.metadata.duration_s = recording.columns.time->values.back() - recording.columns.time->values.front();
  const auto peak = std::ranges::max_element(force->values) - force->values.begin();
  recording.segments = approach_and_retract(static_cast<std::size_t>(peak) + 1, force->values.size());
  calibrate(recording, calibration);
  return std::make_unique<ReadyRecordings>(std::vector{std::move(recording)});
}

}  // namespace

const InstrumentFormat chiaro_format = {"Optics11 Chiaro text", ".txt, also zipped", recognises_chiaro, open_chiaro};

}  // namespace validate
