// A recorded curve on the terminal and as CSV.
#pragma once

#include <string>

#include "compare/results/recording.hpp"

namespace validate {

/// What is in it: metadata, segments, and of each column unit, first and last value, smallest and largest.
std::string recording_text(const Recording& recording);

/// Lines `# key: value` of the metadata, a header of names with units in parentheses, and one row a point, with the
/// number of its segment. A cell is empty where the segment lacks the column. `validate curve` reads it back.
std::string recording_csv(const Recording& recording);

/// Calls visit(name, unit, values) for each column that the recording has.
template <class Visit>
void each_column(const Recording& recording, Visit&& visit) {
  describe(recording.columns, [&](const Field& field, const std::optional<RecordedColumn>& column) {
    if (column) visit(std::string(field.name), column->unit, column->values);
  });
  for (const OtherColumn& other : recording.other_columns) visit(other.name, other.unit, other.values);
}

}  // namespace validate
