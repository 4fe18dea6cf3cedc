// Waves along a line: their amplitude and length.
#pragma once

#include <vector>

namespace validate {

struct Undulation {
  double amplitude_A = 0;   ///< √2 times the root mean square
  double wavelength_A = 0;  ///< of the strongest wave that fits into the line twice or more
};

/// Of heights along a line (places rising), after its smooth shape, a polynomial of fourth degree, is taken away.
/// Throws std::invalid_argument for fewer than 16 points.
Undulation undulation_of(const std::vector<double>& place_A, const std::vector<double>& height_A);

}  // namespace validate
