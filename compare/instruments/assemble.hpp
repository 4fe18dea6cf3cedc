// From segments to one recording: columns that follow one another, and what calibration makes of a deflection.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "compare/instruments/format.hpp"

namespace validate {

/// Columns of one segment, by name; they are equally long.
struct SegmentData {
  RecordedSegment segment;
  std::map<std::string, RecordedColumn, std::less<>> columns;
};

/// The recording's place for a column of this name (force, height (measured), …); null where it has none.
std::optional<RecordedColumn>* place_of(RecordedColumns& columns, std::string_view name);

/// Puts the segments behind one another: sets points, segments, columns and other columns. A column that a segment
/// lacks is NaN there; one that has another unit in some segment is an Error (bad input) that names `file`.
void assemble(Recording& recording, std::vector<SegmentData> segments, std::string_view file);

/// Takes what the caller knows where the file lacks it, notes what it does not take, and makes deflection in m and
/// force of what there is: signal (V or A) · sensitivity, deflection (m) · spring constant.
void calibrate(Recording& recording, const Calibration& calibration);

/// Segments of a cycle in order of time, told apart by the turning point where the file does not say: `turn` is the
/// first index of the way back.
std::vector<RecordedSegment> approach_and_retract(std::size_t turn, std::size_t points);

}  // namespace validate
