#include "compare/potential/law/states.hpp"

#include <algorithm>
#include <cmath>

namespace validate {

CalibrationRange calibration_range(double artefact_bond_A) {
  constexpr double short_of_it_A = 0.02, margin_A = 0.02, longest_A = 1.90;
  const double fitted_A = std::min(artefact_bond_A - short_of_it_A, longest_A);
  return {fitted_A - margin_A, fitted_A};
}

std::vector<atomistic::StrainState> calibration_strains(double bond_A, const CalibrationRange& range) {
  // Denser at small strain, where most of an indented sheet is.
  constexpr double shares[] = {0.055, 0.13, 0.24, 0.4, 0.56, 0.72, 0.86, 1};
  constexpr double usual_A = CalibrationRange{}.holds_A, largest_step = 0.03;
  const double largest = range.holds_A / bond_A - 1, usual = std::min(usual_A / bond_A - 1, largest);
  std::vector<double> strains;  // Green–Lagrange
  const auto add = [&](double stretch) { strains.push_back((stretch * stretch - 1) / 2); };
  for (const double stretch : {0.97, 0.985, 1.0}) add(stretch);
  for (const double share : shares) add(1 + share * usual);
  const int more = static_cast<int>(std::ceil((largest - usual) / largest_step - 1e-9));
  for (int k = 1; k <= more; ++k) add(1 + std::lerp(usual, largest, k / static_cast<double>(more)));

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
