#include "compare/instruments/afm_workshop.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

#include "compare/base/errors.hpp"
#include "compare/instruments/assemble.hpp"
#include "compare/instruments/text.hpp"

namespace validate {
namespace {

constexpr std::string_view first_line = "Force-Distance Curve";

/// The header's keys, and the lines of the table from its own header on.
struct Parts {
  std::map<std::string, std::string, std::less<>> keys;
  std::vector<TextLine> table;
};

Parts parts_of(std::string_view text) {
  Parts parts;
  for (const TextLine& line : lines_of(text)) {
    // Keys have commas too ("X, um", "August 1, 2018"): the table begins at the first line with three.
    if (parts.table.empty() && std::ranges::count(line.text, ',') < 3) {
      const auto colon = line.text.find(":\t");
      if (colon != std::string_view::npos)
        parts.keys.emplace(trimmed(line.text.substr(0, colon)), trimmed(line.text.substr(colon + 2)));
    } else if (!trimmed(line.text).empty()) {
      parts.table.push_back(line);
    }
  }
  return parts;
}

double number(const Parts& parts, std::string_view key) {
  const auto found = parts.keys.find(key);
  return found == parts.keys.end() ? not_known : number_of(found->second).value_or(not_known);
}

std::string text(const Parts& parts, std::string_view key) {
  const auto found = parts.keys.find(key);
  return found == parts.keys.end() ? std::string() : found->second;
}

/// "Wednesday, August 1, 2018" and "15 January 2021" as 2018-08-01.
std::string iso_date(const std::string& date) {
  static constexpr std::array<std::string_view, 12> months = {"january",   "february", "march",    "april",
                                                              "may",       "june",     "july",     "august",
                                                              "september", "october",  "november", "december"};
  int day = 0, month = 0, year = 0;
  std::string plain = lower_case(date);
  std::ranges::replace(plain, ',', ' ');
  for (const std::string_view word : cells_of(plain, ' ')) {
    const auto found = std::ranges::find(months, word);
    if (found != months.end()) month = static_cast<int>(found - months.begin()) + 1;
    if (const auto value = number_of(word); value && *value >= 1 && *value < 10000)
      (*value < 32 ? day : year) = static_cast<int>(*value);
  }
  return day && month && year ? fmt::format("{:04}-{:02}-{:02}", year, month, day) : date;
}

/// "1:06:09 PM" as 13:06:09.
std::string iso_time(const std::string& time) {
  const auto parts = cells_of(time, ' ');
  int hour = 0;
  if (parts.size() != 2) return time;
  const auto [end, error] = std::from_chars(parts[0].data(), parts[0].data() + parts[0].size(), hour);
  if (error != std::errc{} || hour < 1 || hour > 12) return time;
  const bool afternoon = lower_case(parts[1]) == "pm";
  return fmt::format("{:02}{}", hour % 12 + (afternoon ? 12 : 0),
                     std::string_view(end, static_cast<std::size_t>(parts[0].data() + parts[0].size() - end)));
}

RecordingMetadata metadata_of(const Parts& parts) {
  RecordingMetadata m;
  m.format = afm_workshop_format.name;
  m.imaging_mode = "force-distance";
  m.date = iso_date(text(parts, "Date"));
  m.time = iso_time(text(parts, "Time"));
  m.software_version = text(parts, "Software Version");
  m.session_id = m.date + "_" + m.time;
  m.position_x_m = 1e-6 * number(parts, "X, um");
  m.position_y_m = 1e-6 * number(parts, "Y, um");
  if (const double point = number(parts, "Point"); point >= 0 && point < 1e9) {
    m.number = static_cast<int>(point);
    m.curve_id = fmt::format("{}_{}", m.session_id, *m.number);
  }
  // Exactly 1 is the software's default and means that nothing was set.
  if (const double k = number(parts, "Force Constant, nN/nm"); k > 0 && k != 1) m.spring_constant_N_per_m = k;
  if (const double gain = number(parts, "Light Lever Gain, mV/nm"); gain > 0 && gain != 1)
    m.sensitivity_m_per_V = 1e-6 / gain;
  return m;
}

/// Where a column of the table belongs.
struct Place {
  std::size_t segment;  ///< 0 approach, 1 retract
  std::string name, unit;
  double factor;
};

std::optional<Place> place_of_heading(std::string_view heading) {
  const auto open = heading.find('('), close = heading.rfind(')');
  if (open == std::string_view::npos || close == std::string_view::npos || close < open) return std::nullopt;
  const auto unit = si_unit(heading.substr(open + 1, close - open - 1));
  const std::string name = lower_case(trimmed(heading.substr(0, open)));
  const std::size_t segment = name.starts_with("extend ") ? 0 : name.starts_with("retract ") ? 1 : 2;
  if (!unit || segment == 2) return std::nullopt;
  const std::string what = name.substr(name.find(' ') + 1);
  if (what == "z-sense") return Place{segment, "height (measured)", unit->unit, -unit->factor};
  if (what == "t-b") return Place{segment, "deflection", unit->unit, unit->factor};
  if (what == "force") return Place{segment, "force", unit->unit, unit->factor};
  return Place{segment, what, unit->unit, unit->factor};
}

std::vector<SegmentData> table_of(const Parts& parts, const std::string& file) {
  std::vector<SegmentData> segments(2);
  segments[1].segment.kind = SegmentKind::retract;
  std::vector<std::pair<Place, std::vector<double>*>> columns;
  const auto headings = cells_of(parts.table.front().text, ',');
  for (const std::string_view heading : headings) {
    const auto place = place_of_heading(heading);
    if (!place)
      throw bad_input("{}:{}: column '{}'; expected Extend or Retract, a name and a unit: \"Extend Z-Sense(nm)\"", file,
                      parts.table.front().number, printable(heading));
    RecordedColumn& column = segments[place->segment].columns[place->name];
    column.unit = place->unit;
    columns.emplace_back(*place, &column.values);
  }
  for (std::size_t i = 1; i < parts.table.size(); ++i) {
    const TextLine& line = parts.table[i];
    const auto cells = cells_of(line.text, ',');
    if (cells.size() < columns.size())
      throw bad_input("{}:{}: {} cells where the header has {}", file, line.number, cells.size(), columns.size());
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const auto value = number_of(cells[c]);
      if (!value) throw bad_input("{}:{}: '{}' is not a number", file, line.number, printable(cells[c]));
      columns[c].second->push_back(columns[c].first.factor * *value);
    }
  }
  for (SegmentData& part : segments) part.segment.points = static_cast<int>(parts.table.size()) - 1;
  std::erase_if(segments, [](const SegmentData& part) { return part.columns.empty(); });
  return segments;
}

bool recognises_workshop(const FileContent& file) {
  return !file.archive && trimmed(to_utf8(file.bytes.substr(0, 64))).starts_with(first_line);
}

std::unique_ptr<Recordings> open_workshop(const FileContent& file, const Calibration& calibration) {
  const std::string text = to_utf8(file.bytes);
  const Parts parts = parts_of(text);
  if (parts.table.empty())
    throw bad_input("{}: no table: expected a line such as Extend Z-Sense(nm),Extend T-B(V),Retract Z-Sense(nm),…",
                    file.name);
  Recording recording;
  recording.file = file.name;
  recording.metadata = metadata_of(parts);
  recording.index = std::max(recording.metadata.number.value_or(1) - 1, 0);
  assemble(recording, table_of(parts, file.name), file.name);
  calibrate(recording, calibration);
  return std::make_unique<ReadyRecordings>(std::vector{std::move(recording)});
}

}  // namespace

const InstrumentFormat afm_workshop_format = {"AFM Workshop", ".csv, also zipped", recognises_workshop, open_workshop};

}  // namespace validate
