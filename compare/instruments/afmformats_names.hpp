// What afmformats' own files have in common: names of metadata, and the column that numbers the segments.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compare/results/recording.hpp"

namespace validate {

// Sets what has this name ("spring constant"); a name without a place is left out.
void set_metadata(RecordingMetadata& metadata, std::string_view name, double value);
void set_metadata(RecordingMetadata& metadata, std::string_view name, const std::string& value);

/// The same from texts as remarks have them: "spring constant: 0.05 N/m", "springConstant: 0.05",
/// "spring_constant_N_per_m: 0.05". A number with a unit is taken in SI, one without as it is.
void set_metadata_from_text(RecordingMetadata& metadata, std::string_view name, std::string_view text);

/// Segments from a column of their numbers: two are approach and retract, three have a pause between, four begin with
/// one more. Throws Error (bad input), which `label` starts, for more.
std::vector<RecordedSegment> numbered_segments(const std::vector<double>& numbers, const std::string& label);

/// Segments told apart by where the height or depth turns: for a file that does not number them. Sets segments and
/// points, and notes it where there are two.
void split_at_turn(Recording& recording);

}  // namespace validate
