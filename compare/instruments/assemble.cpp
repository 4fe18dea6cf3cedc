#include "compare/instruments/assemble.hpp"

#include <algorithm>
#include <cmath>

#include "compare/base/errors.hpp"

namespace validate {
namespace {

std::vector<double>& column_of(Recording& recording, const std::string& name, const std::string& unit,
                               std::string_view file) {
  std::string* has = nullptr;
  std::vector<double>* values = nullptr;
  if (auto* place = place_of(recording.columns, name)) {
    if (!*place) place->emplace().unit = unit;
    has = &(*place)->unit, values = &(*place)->values;
  } else {
    const auto found = std::ranges::find(recording.other_columns, name, &OtherColumn::name);
    OtherColumn& other = found != recording.other_columns.end()
                             ? *found
                             : recording.other_columns.emplace_back(OtherColumn{name, unit, {}});
    has = &other.unit, values = &other.values;
  }
  if (*has != unit)
    throw bad_input("{}: the column '{}' is in {} in one segment and in {} in another", file, name, *has, unit);
  return *values;
}

void fill_up(Recording& recording, std::size_t points) {
  const auto to = [points](std::vector<double>& values) { values.resize(points, not_known); };
  describe(recording.columns, [&](const Field&, std::optional<RecordedColumn>& column) {
    if (column) to(column->values);
  });
  for (OtherColumn& other : recording.other_columns) to(other.values);
}

std::optional<RecordedColumn> times(const RecordedColumn& column, double factor, const char* unit) {
  RecordedColumn product{unit, column.values};
  for (double& value : product.values) value *= factor;
  return product;
}

double z_range(const Recording& recording) {
  if (!recording.columns.height_piezo) return not_known;
  double low = INFINITY, high = -INFINITY;
  for (const double z : recording.columns.height_piezo->values)
    if (std::isfinite(z)) low = std::min(low, z), high = std::max(high, z);
  return high >= low ? high - low : not_known;
}

/// The caller's number where the file has none; the file's own is not overruled in silence.
void stand_in(Recording& recording, double& own, const std::optional<double>& given, const char* flag) {
  if (!given) return;
  if (!std::isfinite(own)) {
    own = *given;
  } else if (std::abs(own - *given) > 1e-6 * std::abs(own)) {
    recording.notes.push_back(fmt::format("{} {:g} is not used: the file has its own, {:g}", flag, *given, own));
  }
}

}  // namespace

std::optional<RecordedColumn>* place_of(RecordedColumns& columns, std::string_view name) {
  std::optional<RecordedColumn>* place = nullptr;
  describe(columns, [&](const Field& field, std::optional<RecordedColumn>& column) {
    if (field.name == name) place = &column;
  });
  return place;
}

void assemble(Recording& recording, std::vector<SegmentData> segments, std::string_view file) {
  std::size_t points = 0;
  for (SegmentData& part : segments) {
    std::size_t length = static_cast<std::size_t>(part.segment.points);
    for (auto& [name, column] : part.columns) {
      if (column.values.size() != length)
        throw bad_input("{}: segment {} has {} points in '{}' and {} elsewhere", file, recording.segments.size(),
                        column.values.size(), name, length);
      std::vector<double>& whole = column_of(recording, name, column.unit, file);
      if (auto* place = place_of(recording.columns, name); place && (*place)->heading.empty())
        (*place)->heading = column.heading;
      whole.resize(points, not_known);
      whole.insert(whole.end(), column.values.begin(), column.values.end());
    }
    points += length;
    fill_up(recording, points);
    recording.segments.push_back(std::move(part.segment));
  }
  recording.metadata.points = static_cast<int>(points);
}

void calibrate(Recording& recording, const Calibration& calibration) {
  RecordingMetadata& m = recording.metadata;
  if (!std::isfinite(m.z_range_m)) m.z_range_m = z_range(recording);
  RecordedColumns& columns = recording.columns;
  const bool current = columns.deflection && columns.deflection->unit == "A";
  stand_in(recording, m.spring_constant_N_per_m, calibration.spring_constant_N_per_m, "--spring-constant");
  stand_in(recording, current ? m.sensitivity_m_per_A : m.sensitivity_m_per_V, calibration.sensitivity,
           "--sensitivity");
  const double sensitivity = current ? m.sensitivity_m_per_A : m.sensitivity_m_per_V;
  if (columns.deflection && columns.deflection->unit != "m" && std::isfinite(sensitivity))
    columns.deflection = times(*columns.deflection, sensitivity, "m");
  if (columns.deflection && columns.deflection->unit == "m" && !columns.force &&
      std::isfinite(m.spring_constant_N_per_m))
    columns.force = times(*columns.deflection, m.spring_constant_N_per_m, "N");
}

std::vector<RecordedSegment> approach_and_retract(std::size_t turn, std::size_t points) {
  std::vector<RecordedSegment> segments;
  if (turn > 0) segments.push_back({.kind = SegmentKind::approach, .points = static_cast<int>(turn)});
  if (turn < points) segments.push_back({.kind = SegmentKind::retract, .points = static_cast<int>(points - turn)});
  return segments;
}

}  // namespace validate
