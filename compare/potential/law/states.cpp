#include "compare/potential/law/states.hpp"

#include <cmath>

namespace validate {

std::vector<atomistic::StrainState> calibration_strains(double bond_A) {
  // Denser at small strain, where most of an indented sheet is.
  constexpr double shares[] = {0.055, 0.13, 0.24, 0.4, 0.56, 0.72, 0.86, 1};
  const double largest = longest_calibrated_bond_A / bond_A - 1;
  std::vector<double> strains;  // Green–Lagrange
  const auto add = [&](double stretch) { strains.push_back((stretch * stretch - 1) / 2); };
  for (const double stretch : {0.97, 0.985, 1.0}) add(stretch);
  for (const double share : shares) add(1 + share * largest);

  std::vector<atomistic::StrainState> states;
  for (const double one : strains) {
    for (const double two : strains) {
      if (one < two) continue;
      states.push_back({one, two, 0, averaged_deg});
      if (one == two) continue;
      states.push_back({one, two, 0, zigzag_deg});
      states.push_back({one, two, 0, armchair_deg});
    }
  }
  return states;
}

double size_of(const atomistic::HomogeneousState& state) {
  constexpr double smallest_eV_per_A2 = 0.1;
  return std::hypot(state.S11_eV_per_A2, state.S22_eV_per_A2, smallest_eV_per_A2);
}

}  // namespace validate
