// The finite-strain sheet's force over the shallow one's along a path.
#pragma once

#include <vector>

#include "compare/fitting/shallow_sheet.hpp"
#include "compare/fitting/sheet_physics.hpp"

namespace validate {

struct RatioCurve {
  std::vector<double> log_depth, ratio;
  double last_level = 0;  ///< the deepest controlled depth reached
};

/// Controlled depths (Å) that are solved: not beyond where a law was seen to end.
struct Levels {
  double low, high;
  bool law_ends = false;  ///< at `high`, where the force bends most
};

/// At levels in equal ratios, shifted by `offset` of their spacing; where the law ends before the last, close to its
/// end. Throws std::runtime_error where fewer than six are reached.
RatioCurve solved_ratio(const MembraneTip& tip, const ShallowSheet& shallow, double Eh, double pretension,
                        const Levels& between, int depths, double offset = 0);

}  // namespace validate
