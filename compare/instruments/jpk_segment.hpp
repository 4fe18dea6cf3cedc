// One segment of a JPK curve: its settings and the columns that are made of its channels.
#pragma once

#include <string>

#include "compare/instruments/assemble.hpp"
#include "compare/instruments/properties.hpp"

namespace validate {

struct JpkSegment {
  SegmentData data;
  Properties header;  ///< references resolved
  std::string approach_id, settings_type;
  double planned_duration_s = not_known, stroke_m = not_known;
  double sensitivity_m_per_V = not_known, spring_constant_N_per_m = not_known;  ///< as this segment's file has them
};

/// Reads the segment in a folder of the archive (with its slash). Throws Error (bad input), which `label` starts.
JpkSegment read_jpk_segment(const Archive& archive, const std::string& folder, const Properties& shared,
                            const std::string& label);

}  // namespace validate
