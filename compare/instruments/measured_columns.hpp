// The columns of a recording that a fit takes.
#pragma once

#include "compare/input/measured_curve.hpp"
#include "compare/results/recording.hpp"

namespace validate {

/// What the column of depths holds.
enum class DepthSource { depth, height, tip };

struct MeasuredColumns {
  RecordedColumn depth, force;
  DepthSource source = DepthSource::depth;
  std::optional<RecordedColumn> sigma, sigma_depth;
  std::string sigma_name;
};

/// By name, or as chosen. Throws Error (bad input) that names the columns there are.
MeasuredColumns measured_columns(const Recording& recording, const ColumnChoice& choice);

}  // namespace validate
