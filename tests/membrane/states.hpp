// Named strains at which every law is tried, the tries over them.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "membrane/laws/list.hpp"

namespace membrane::testing {

inline CauchyBorn some_lattice() { return CauchyBorn::examples().front().law; }
inline CauchyBornTable some_table() { return CauchyBornTable::examples().front().law; }
inline CauchyBornSixfold some_hexagonal_lattice(double zigzag_rad) {
  return turned(CauchyBornSixfold::examples().front().law, zigzag_rad);
}

/// Calls visit(law) for each of example_laws(), inside a trace of its name.
template <class Visit>
void over_laws(Visit visit) {
  for (const auto& [name, any] : example_laws()) {
    SCOPED_TRACE(name);
    std::visit(visit, any);
  }
}

struct NamedStrain {
  std::string name;
  Voigt strain;  ///< [E11, E22, 2 E12]
};

/// Strain with principal values e1 ≥ e2, the larger at an angle (radians) to x.
inline Voigt principal_at(double e1, double e2, double angle) {
  const double mean = 0.5 * (e1 + e2);
  const double half = 0.5 * (e1 - e2);
  return {mean + half * std::cos(2 * angle), mean - half * std::cos(2 * angle), 2 * half * std::sin(2 * angle)};
}

inline constexpr double border_distance = 1e-4;

/// States for a law whose natural width at strain e is width(e).
template <class Width>
std::vector<NamedStrain> named_strains(Width width) {
  const double e = 0.05;
  std::vector<NamedStrain> states{{"rest", Voigt::Zero()},
                                  {"nearly uniaxial", principal_at(e, width(e) + 0.01, 0)},
                                  {"biaxial", principal_at(e, e, 0.3)},
                                  {"nearly biaxial", principal_at(e, e - 1e-9, 0.3)},
                                  {"shear", Voigt(0, 0, 0.06)},
                                  {"taut, near the wrinkled border", principal_at(e, width(e) + border_distance, 0.7)},
                                  {"wrinkled, near the taut border", principal_at(e, width(e) - border_distance, 0.7)},
                                  {"wrinkled, near the slack border", principal_at(border_distance, -e, 1.1)},
                                  {"slack, near the wrinkled border", principal_at(-border_distance, -e, 1.1)},
                                  {"wrinkled", principal_at(e, -0.2, -0.4)},
                                  {"slack", principal_at(-0.01, -0.02, 0.2)}};
  std::mt19937 random(20100407);
  std::uniform_real_distribution<double> any(-0.1, 0.1);
  for (int i = 0; i < 8; ++i)
    states.push_back({"random " + std::to_string(i), Voigt(any(random), any(random), any(random))});
  return states;
}

}  // namespace membrane::testing
