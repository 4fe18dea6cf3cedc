#include "compare/instruments/headings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "compare/base/describe.hpp"
#include "compare/base/errors.hpp"
#include "compare/base/units.hpp"
#include "compare/instruments/afmformats_names.hpp"

namespace validate {
namespace {

constexpr double m_per_A = 1e-10, N_per_nN = 1e-9;
constexpr std::string_view no_unit_mark = " (no unit)";

/// Names in lower case, letters and digits alone, and the column that they mean. An exact name goes before a beginning.
struct Meaning {
  std::string_view name, column;
  bool beginning = true;  ///< longer names that begin so mean the same
};
constexpr std::array meanings = {Meaning{"heightmeasured", "height (measured)"},
                                 Meaning{"measuredheight", "height (measured)"},
                                 Meaning{"smoothedmeasuredheight", "height (measured)"},
                                 Meaning{"capacitivesensorheight", "height (measured)"},
                                 Meaning{"straingaugeheight", "height (measured)"},
                                 Meaning{"heightsensor", "height (measured)"},
                                 Meaning{"zsensor", "height (measured)"},
                                 Meaning{"zsnsr", "height (measured)"},
                                 Meaning{"zsense", "height (measured)"},
                                 Meaning{"height", "height (piezo)"},
                                 Meaning{"headheight", "height (piezo)"},
                                 Meaning{"piezo", "height (piezo)"},
                                 Meaning{"zpiezo", "height (piezo)"},
                                 Meaning{"calcramp", "height (piezo)"},
                                 Meaning{"ramp", "height (piezo)"},
                                 Meaning{"z", "height (piezo)", false},
                                 Meaning{"raw", "height (piezo)", false},
                                 Meaning{"tipposition", "tip position"},
                                 Meaning{"tipsampleseparation", "tip position"},
                                 Meaning{"separation", "tip position"},
                                 Meaning{"deflection", "deflection"},
                                 Meaning{"defl", "deflection"},
                                 Meaning{"vdeflection", "deflection"},
                                 Meaning{"verticaldeflection", "deflection"},
                                 Meaning{"cantilever", "deflection"},
                                 Meaning{"depth", "depth"},
                                 Meaning{"indentation", "depth"},
                                 Meaning{"displacement", "depth"},
                                 Meaning{"force", "force"},
                                 Meaning{"load", "force"},
                                 Meaning{"f", "force", false},
                                 Meaning{"time", "time"},
                                 Meaning{"seriestime", "time"},
                                 Meaning{"segment", "segment", false}};

std::string letters(std::string_view name) {
  std::string plain;
  for (const char c : lower_case(name))
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) plain += c;
  return plain;
}

std::string column_of(std::string_view name) {
  const std::string plain = letters(name);
  std::size_t longest = 0;
  std::string_view column;
  for (const Meaning& meaning : meanings)
    if (plain == meaning.name ||
        (meaning.beginning && plain.starts_with(meaning.name) && meaning.name.size() > longest))
      longest = plain == meaning.name ? std::string::npos : meaning.name.size(), column = meaning.column;
  return std::string(column);
}

bool is_length(std::string_view column) { return column != "force" && column != "time" && !column.empty(); }

/// One of the unit in base units, if the text is a unit of that quantity.
std::optional<double> in_base(const std::string& text, std::string_view base) {
  try {
    return text.empty() ? std::nullopt : std::optional(parse_quantity("1 " + text, base, ""));
  } catch (const Error&) {
    return std::nullopt;
  }
}

std::optional<SiUnit> unit_for(std::string_view column, std::string text) {
  for (auto at = text.find("_per_"); at != std::string::npos; at = text.find("_per_")) text.replace(at, 5, 1, '/');
  if (is_length(column))
    if (const auto length = in_base(text, unit::length)) return SiUnit{*length * m_per_A, "m"};
  if (!is_length(column) && column != "time")
    if (const auto force = in_base(text, unit::force)) return SiUnit{*force * nN_per_eV_per_A * N_per_nN, "N"};
  return si_unit(text);
}

/// Takes a word for a direction off a name.
std::optional<SegmentKind> take_direction(std::string& name) {
  struct Direction {
    std::string_view word;
    SegmentKind kind;
  };
  using enum SegmentKind;
  static constexpr std::array words = {Direction{"_ex", approach},      Direction{"_rt", retract},
                                       Direction{"extend", approach},   Direction{"retract", retract},
                                       Direction{"approach", approach}, Direction{"withdraw", retract},
                                       Direction{"retrace", retract},   Direction{"trace", approach}};
  const std::string lower = lower_case(name);
  for (const auto& [word, kind] : words) {
    const auto at = lower.find(word);
    const auto end = at + word.size();
    const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
    if (at == std::string::npos || (end < lower.size() && is_letter(lower[end]))) continue;
    if (word.front() != '_' && at > 0 && is_letter(lower[at - 1])) continue;
    name.erase(at, word.size());
    const auto from = name.find_first_not_of(" _-:"), to = name.find_last_not_of(" _-:");
    name = from == std::string::npos ? "" : name.substr(from, to - from + 1);
    return kind;
  }
  return std::nullopt;
}

/// A name and the text of its unit, where the end of a cell is one.
std::pair<std::string, std::string> parted(const std::string& cell) {
  for (const auto& [open, close] : {std::pair{'(', ')'}, {'[', ']'}}) {
    const auto from = cell.rfind(open), to = cell.rfind(close);
    if (from == std::string::npos || to == std::string::npos || to < from) continue;
    std::string name(trimmed(cell.substr(0, from))), text(trimmed(cell.substr(from + 1, to - from - 1)));
    if (unit_for(column_of(name), text)) return {std::move(name), std::move(text)};
  }
  for (const char mark : {'_', ' ', ',', '/'})
    for (auto at = cell.find(mark); at != std::string::npos; at = cell.find(mark, at + 1)) {
      std::string name(trimmed(cell.substr(0, at))), text(trimmed(cell.substr(at + 1)));
      if (!name.empty() && unit_for(column_of(name), text)) return {std::move(name), std::move(text)};
    }
  return {cell, ""};
}

void put(SegmentData& into, const HeadedColumn& column, std::vector<double> values) {
  const Heading& heading = column.heading;
  std::string name = kept_as(heading);
  if (into.columns.contains(name)) name = heading.cell;
  RecordedColumn& place = into.columns[name];
  if (!place.values.empty()) return;  // a heading that occurs twice: the first counts
  place.unit = heading.unit ? heading.unit->unit : "";
  place.heading = heading.cell;
  for (double& value : values) value *= heading.unit ? heading.unit->factor : 1;
  place.values = std::move(values);
}

/// The columns of one direction, without the rows that have none of them.
SegmentData of_direction(const std::vector<HeadedColumn>& columns, SegmentKind kind) {
  std::vector<std::size_t> rows;
  const std::size_t size = columns.front().values.size();
  for (std::size_t i = 0; i < size; ++i)
    if (std::ranges::any_of(
            columns, [&](const HeadedColumn& c) { return c.heading.direction == kind && std::isfinite(c.values[i]); }))
      rows.push_back(i);
  SegmentData part;
  part.segment = {.kind = kind, .points = static_cast<int>(rows.size())};
  for (const HeadedColumn& column : columns) {
    if (column.heading.direction && column.heading.direction != kind) continue;
    std::vector<double> values;
    for (const std::size_t i : rows) values.push_back(column.values[i]);
    put(part, column, std::move(values));
  }
  return part;
}

}  // namespace

Heading heading_of(std::string_view cell, std::string_view unit_apart) {
  Heading heading;
  heading.cell = std::string(trimmed(cell));
  std::string rest = heading.cell;
  heading.direction = take_direction(rest);
  const auto [name, text] = unit_apart.empty() ? parted(rest) : std::pair(rest, std::string(unit_apart));
  heading.name = name;
  heading.column = column_of(name);
  std::string bare = text;
  std::erase_if(bare, [](char c) { return c == '(' || c == ')' || c == '[' || c == ']'; });
  heading.unit = unit_for(heading.column, bare);
  const std::string plain = letters(name);
  if (text.empty() && (plain == "raw" || plain == "zsnsr" || plain == "defl")) heading.unit = SiUnit{1, "m"};  // Igor's
  if (heading.column == "deflection" && heading.unit && heading.unit->unit == "N") heading.column = "force";
  if (heading.column == "segment") heading.unit = SiUnit{1, ""};
  const bool fits =
      heading.unit && (heading.column == "force"  ? heading.unit->unit == "N"
                       : heading.column == "time" ? heading.unit->unit == "s"
                       : heading.column == "deflection"
                           ? heading.unit->unit == "m" || heading.unit->unit == "V" || heading.unit->unit == "A"
                       : is_length(heading.column) && heading.column != "segment" ? heading.unit->unit == "m"
                                                                                  : true);
  if (!fits && !heading.column.empty()) heading.column.clear();
  return heading;
}

std::string kept_as(const Heading& heading) {
  if (heading.unit && !heading.column.empty()) return heading.column;
  RecordedColumns columns;
  return place_of(columns, heading.cell) ? heading.cell + std::string(no_unit_mark) : heading.cell;
}

std::string_view without_mark(std::string_view name) {
  if (name.ends_with(no_unit_mark)) name.remove_suffix(no_unit_mark.size());
  return name;
}

void place_headed(Recording& recording, std::vector<HeadedColumn> columns, const std::string& label) {
  if (columns.empty()) return;
  const auto of = [&](SegmentKind kind) {
    return std::ranges::any_of(columns, [kind](const HeadedColumn& c) { return c.heading.direction == kind; });
  };
  std::vector<SegmentData> parts;
  for (const SegmentKind kind : {SegmentKind::approach, SegmentKind::retract})
    if (of(kind)) parts.push_back(of_direction(columns, kind));
  if (!parts.empty()) return assemble(recording, std::move(parts), label);

  SegmentData whole;
  whole.segment.points = static_cast<int>(columns.front().values.size());
  std::vector<RecordedSegment> numbered;
  for (HeadedColumn& column : columns) {
    if (column.heading.column == "segment" && numbered.empty())
      numbered = numbered_segments(column.values, label);
    else
      put(whole, column, std::move(column.values));
  }
  std::vector<SegmentData> one;
  one.push_back(std::move(whole));
  assemble(recording, std::move(one), label);
  if (numbered.empty())
    split_at_turn(recording);
  else
    recording.segments = std::move(numbered);
}

}  // namespace validate
