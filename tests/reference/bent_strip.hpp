// A stretched strip of width H bent in its plane: tension P, moment M, tension field, small strain.
//
// Fibres bear E·h κ times their distance from the wrinkled band of width b, and nothing inside it. The
// resultant lies two thirds up the taut part, and P = ½ E·h κ (H − b)²; hence for 1/6 ≤ M/(P H) < ½
//   b/H = 3 M/(P H) − ½,   2 M/(P H) = 1 − ⅔ √(2 P/(E·h κ H²));
// below 1/6 the strip is a beam, κ = 12 M/(E·h H³). Stein & Hedgepeth, NASA TN D-813 (1961). Closed form.
#pragma once

#include <cmath>

namespace reference {

/// b/H for 0 ≤ M/(P H) < ½.
inline double bent_strip_band(double moment_over_PH) {
  return moment_over_PH <= 1.0 / 6 ? 0 : 3 * moment_over_PH - 0.5;
}

/// κ E·h H²/P for 0 ≤ M/(P H) < ½.
inline double bent_strip_curvature(double moment_over_PH) {
  if (moment_over_PH <= 1.0 / 6) return 12 * moment_over_PH;
  const double taut = 1 - bent_strip_band(moment_over_PH);
  return 2 / (taut * taut);
}

}  // namespace reference
