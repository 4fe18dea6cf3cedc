// How a number that is not known is written: NaN inside the program, null in JSON, an empty cell in CSV, never 0.
#pragma once

#include <limits>

namespace validate {

inline constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

}  // namespace validate
