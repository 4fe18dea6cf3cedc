// A force curve as an instrument recorded it: segments, columns and what the file says of the experiment. SI units, and
// the zeros of the file.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compare/base/describe.hpp"
#include "compare/base/words.hpp"
#include "compare/results/known.hpp"

namespace validate {

/// What the instrument did meanwhile.
enum class SegmentKind { approach, retract, pause };
constexpr auto words(SegmentKind) {
  return std::array{Word{SegmentKind::approach, "approach"}, Word{SegmentKind::retract, "retract"},
                    Word{SegmentKind::pause, "pause"}};
}

struct RecordedSegment {
  SegmentKind kind = SegmentKind::approach;
  int points = 0;
  double duration_s = not_known;
  double setpoint_V = not_known;
  double baseline_V = not_known;
  std::string time_stamp;
};

void describe(SameStruct<RecordedSegment> auto& segment, auto&& visit) {
  visit(Field{"kind", unit::none, "what the instrument did"}, segment.kind);
  visit(Field{"points", unit::none, "of every column, one segment after another", not_negative()}, segment.points);
  visit(Field{"duration", unit::second, "from its first point to the next segment's"}.where_known(),
        segment.duration_s);
  visit(Field{"setpoint", unit::volt, "at which it was to end"}.where_known(), segment.setpoint_V);
  visit(Field{"baseline", unit::volt, "of the deflection, as the instrument took it"}.where_known(),
        segment.baseline_V);
  visit(Field{"time_stamp", unit::none, "as the file has it"}.where_known(), segment.time_stamp);
}

/// One value a point; NaN where a segment lacks the column.
struct RecordedColumn {
  std::string unit;
  std::vector<double> values;
  std::string heading = {};  ///< of a table, as the file has it; in no document
};

void describe(SameStruct<RecordedColumn> auto& column, auto&& visit) {
  visit(Field{"unit", unit::none, "SI: m, N, s; V or A of a deflection that nothing calibrates"}, column.unit);
  visit(Column{"values", unit::none, "one a point; null where a segment lacks the column"}, column.values);
}

/// A column that has no place of its own.
struct OtherColumn {
  std::string name, unit;
  std::vector<double> values;
};

void describe(SameStruct<OtherColumn> auto& column, auto&& visit) {
  visit(Field{"name", unit::none, "as the file has it"}, column.name);
  visit(Field{"unit", unit::none, "SI where the file gives one"}.where_known(), column.unit);
  visit(Column{"values", unit::none, "one a point; null where a segment lacks the column"}, column.values);
}

struct RecordedColumns {
  std::optional<RecordedColumn> force;            ///< positive where the tip presses
  std::optional<RecordedColumn> height_measured;  ///< of the cantilever's base by a sensor; falls towards the sample
  std::optional<RecordedColumn> height_piezo;     ///< the same from what drives the piezo
  std::optional<RecordedColumn> tip_position;
  std::optional<RecordedColumn> deflection;  ///< of the cantilever: m, or the detector's V or A
  std::optional<RecordedColumn> depth;       ///< of a table that has depths
  std::optional<RecordedColumn> time;
};

void describe(SameStruct<RecordedColumns> auto& columns, auto&& visit) {
  visit(Field{"force", unit::none, "positive where the tip presses"}.where_known(), columns.force);
  visit(Field{"height (measured)", unit::none, "of the cantilever's base, by a sensor"}.where_known(),
        columns.height_measured);
  visit(Field{"height (piezo)", unit::none, "the same from what drives the piezo"}.where_known(), columns.height_piezo);
  visit(Field{"tip position", unit::none, "of the tip itself"}.where_known(), columns.tip_position);
  visit(Field{"deflection", unit::none, "of the cantilever"}.where_known(), columns.deflection);
  visit(Field{"depth", unit::none, "of a table that has depths"}.where_known(), columns.depth);
  visit(Field{"time", unit::none, "since the first point"}.where_known(), columns.time);
}

/// What the file says of the experiment; what it does not say is left out.
struct RecordingMetadata {
  std::string format, imaging_mode, feedback_mode, instrument, software, software_version;
  std::string curve_id, session_id, date, time;
  std::optional<int> number;  ///< of the curve in its scan, as the instrument counts
  std::optional<int> grid_index_x, grid_index_y, grid_shape_x, grid_shape_y;
  int points = 0;
  double duration_s = not_known;
  double spring_constant_N_per_m = not_known;
  double sensitivity_m_per_V = not_known, sensitivity_m_per_A = not_known;
  double setpoint = not_known;
  std::string setpoint_unit;
  double position_x_m = not_known, position_y_m = not_known;
  double grid_center_x_m = not_known, grid_center_y_m = not_known;
  double grid_size_x_m = not_known, grid_size_y_m = not_known;
  double rate_approach_Hz = not_known, rate_retract_Hz = not_known;
  double speed_approach_m_per_s = not_known, speed_retract_m_per_s = not_known;
  double z_range_m = not_known, tip_radius_m = not_known;
};

namespace detail {

template <class Self, class Visitor>
void describe_place(Self& m, Visitor&& visit) {
  visit(Field{"position_x", unit::metre, "of the curve"}.where_known(), m.position_x_m);
  visit(Field{"position_y", unit::metre, "of the curve"}.where_known(), m.position_y_m);
  visit(Field{"grid_index_x", unit::none, "column of the map, from 0"}.where_known(), m.grid_index_x);
  visit(Field{"grid_index_y", unit::none, "row of the map, from 0"}.where_known(), m.grid_index_y);
  visit(Field{"grid_shape_x", unit::none, "columns of the map"}.where_known(), m.grid_shape_x);
  visit(Field{"grid_shape_y", unit::none, "rows of the map"}.where_known(), m.grid_shape_y);
  visit(Field{"grid_center_x", unit::metre, "of the map"}.where_known(), m.grid_center_x_m);
  visit(Field{"grid_center_y", unit::metre, "of the map"}.where_known(), m.grid_center_y_m);
  visit(Field{"grid_size_x", unit::metre, "outer width of the map"}.where_known(), m.grid_size_x_m);
  visit(Field{"grid_size_y", unit::metre, "outer height of the map"}.where_known(), m.grid_size_y_m);
}

}  // namespace detail

void describe(SameStruct<RecordingMetadata> auto& m, auto&& visit) {
  visit(Field{"format", unit::none, "of the file, told by its content"}, m.format);
  visit(Field{"imaging_mode", unit::none, "force-distance, creep-compliance, stress-relaxation"}.where_known(),
        m.imaging_mode);
  visit(Field{"feedback_mode", unit::none, "of the instrument"}.where_known(), m.feedback_mode);
  visit(Field{"instrument", unit::none, "as the file has it"}.where_known(), m.instrument);
  visit(Field{"software", unit::none, "that wrote the file"}.where_known(), m.software);
  visit(Field{"software_version", unit::none, "as the file has it"}.where_known(), m.software_version);
  visit(Field{"curve_id", unit::none, "of the curve among all of a session"}.where_known(), m.curve_id);
  visit(Field{"session_id", unit::none, "of the session"}.where_known(), m.session_id);
  visit(Field{"date", unit::none, "YYYY-MM-DD where the file tells, else as it has it"}.where_known(), m.date);
  visit(Field{"time", unit::none, "of the day, local"}.where_known(), m.time);
  visit(Field{"enum", unit::none, "number of the curve, as the instrument counts"}.where_known(), m.number);
  visit(Field{"point_count", unit::none, "of all segments"}, m.points);
  visit(Field{"duration", unit::second, "of all segments"}.where_known(), m.duration_s);
  visit(Field{"spring_constant", unit::newton_per_metre, "of the cantilever"}.where_known(), m.spring_constant_N_per_m);
  visit(Field{"sensitivity", unit::metre_per_volt, "of the deflection"}.where_known(), m.sensitivity_m_per_V);
  visit(Field{"sensitivity", unit::metre_per_ampere, "where the detector's signal is a current"}.where_known(),
        m.sensitivity_m_per_A);
  visit(Field{"setpoint", unit::none, "of the approach, relative to the baseline"}.where_known(), m.setpoint);
  visit(Field{"setpoint_unit", unit::none, "N, or V without calibration"}.where_known(), m.setpoint_unit);
  visit(Field{"tip_radius", unit::metre, "as the file has it"}.where_known(), m.tip_radius_m);
  detail::describe_place(m, visit);
  visit(Field{"rate_approach", unit::hertz, "points a second"}.where_known(), m.rate_approach_Hz);
  visit(Field{"rate_retract", unit::hertz, "points a second"}.where_known(), m.rate_retract_Hz);
  visit(Field{"speed_approach", unit::metre_per_second, "as commanded"}.where_known(), m.speed_approach_m_per_s);
  visit(Field{"speed_retract", unit::metre_per_second, "as commanded"}.where_known(), m.speed_retract_m_per_s);
  visit(Field{"z_range", unit::metre, "from the lowest to the highest height (piezo)"}.where_known(), m.z_range_m);
}

struct Recording {
  std::string file;  ///< with the member's name where it is an archive
  int index = 0;     ///< place in the scan, from 0: a map with gaps leaves numbers out
  RecordingMetadata metadata;
  std::vector<RecordedSegment> segments;
  RecordedColumns columns;
  std::vector<OtherColumn> other_columns;
  std::vector<std::string> notes;              ///< what was left out or put right
  std::map<std::string, std::string> remarks;  ///< `key: value` lines of a text, keys in lower case; in no document
  std::vector<std::string> headings;           ///< of a table, in its order; in no document
  int header_line = 0;                         ///< where they stand

  /// Points of all segments together.
  int points() const {
    int sum = 0;
    for (const RecordedSegment& segment : segments) sum += segment.points;
    return sum;
  }
};

void describe(SameStruct<Recording> auto& curve, auto&& visit) {
  visit(Field{"file", unit::none, "that was read, with the archive's member"}, curve.file);
  visit(Field{"index", unit::none, "place in the scan, from 0; a map with gaps leaves numbers out"}, curve.index);
  visit(Field{"metadata", unit::none, "what the file says of the experiment"}, curve.metadata);
  visit(Field{"segments", unit::none, "in the order of time; their points follow one another in every column"},
        curve.segments);
  visit(Field{"columns", unit::none, "by name, equally long"}, curve.columns);
  visit(Field{"other_columns", unit::none, "that have no place of their own"}.where_known(), curve.other_columns);
  visit(Field{"notes", unit::none, "what was left out or put right"}.where_known(), curve.notes);
}

}  // namespace validate
