// From a file of any format to curves that can be fitted: one segment, force and depth with the signs that physics asks
// for.
#pragma once

#include <filesystem>
#include <vector>

#include "compare/input/measured_curve.hpp"
#include "compare/instruments/format.hpp"

namespace validate {

/// What is taken of a file, and what is known where it does not say.
struct MeasuredRequest {
  ColumnChoice columns = {};
  SegmentKind segment = SegmentKind::approach;  ///< the first of this kind
  Calibration calibration = {};
  std::vector<int> curves = {};  ///< of a file with several these alone, by their index; empty: all
};

/// Every curve of a file that is asked for. Depths are a column of depths (a sheet's deflection, too, where there is no
/// height), else heights of the cantilever's base, else tip positions. A table's zeros and the sign of its depths are
/// kept; heights and tip positions grow towards the sample afterwards, forces where it is pressed, and instruments'
/// heights begin at the first estimate of the contact. Rows without a finite force and depth are skipped. What was done
/// stands in `notes`. Throws Error: bad input with file, line and what is expected; file failed if the file cannot be
/// read.
std::vector<MeasuredCurve> read_measured(const std::filesystem::path& file, const MeasuredRequest& request = {});

}  // namespace validate
