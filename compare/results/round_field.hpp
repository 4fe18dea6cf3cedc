// A round membrane seen from above, at one depth.
#pragma once

#include <string>
#include <vector>

namespace validate {

/// Values on circles, from the centre to the rim.
struct RoundField {
  std::string load;
  double tip_A = 0;                            ///< 0: a point
  std::vector<double> radius_A;                ///< of the circles, deformed
  std::vector<double> larger_force_eV_per_A2;  ///< larger principal Cauchy stress times thickness
};

}  // namespace validate
