// Named strains at which every law is tried, and the laws themselves.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "membrane/laws/list.hpp"

namespace membrane::testing {

struct NamedLaw {
  std::string name;
  Law law;
};

/// A law like one fitted to a potential: AIREBO's constants, every kind of term, odd powers of q with them.
inline CauchyBorn some_lattice() {
  return {17.33,
          0.3645,
          {{3, 0, -14.0},
           {1, 2, -30.0},
           {0, 3, 25.0},
           {4, 0, 5.0},
           {2, 2, 20.0},
           {1, 3, -35.0},
           {0, 4, -40.0},
           {2, 3, 11.0},
           {3, 2, -17.0},
           {0, 5, 60.0},
           {1, 5, 30.0},
           {6, 0, 3.0}}};
}

/// The same as a table, its coefficients without any order, and with directions.
inline CauchyBornTable some_table() {
  CauchyBornTable law{17.33, 0.3645, {-0.2, 0.35, 3}, {0, 0.18, 2}, {}};
  for (int k = 0; k < law.coefficient_count(); ++k)
    law.coefficients_eV_per_A2.push_back(-4 + 1.5 * std::sin(1.7 * k * k));
  return law;
}
inline CauchyBornSixfold some_hexagonal_lattice(double zigzag_rad) {
  CauchyBornSixfold law{17.33, 0.3645, zigzag_rad, {}};
  for (const auto& [a, b, c] : some_lattice().terms) law.terms.push_back({a, b, Sixfold::none, c});
  law.terms.push_back({0, 3, Sixfold::cosine, 20});
  law.terms.push_back({0, 3, Sixfold::knots, 15});
  law.terms.push_back({1, 3, Sixfold::cosine, -30});
  law.terms.push_back({0, 4, Sixfold::cosine, 10});
  law.terms.push_back({1, 3, Sixfold::knots, 8});
  law.terms.push_back({0, 6, Sixfold::cosine_squared, -25});
  return law;
}

/// The same sheet, turned in its plane together with its lattice.
template <IsotropicLaw L>
L turned(const L& law, double) {
  return law;
}
inline CauchyBornSixfold turned(CauchyBornSixfold law, double angle) {
  law.zigzag_rad += angle;
  return law;
}

/// Each law on the list, at every Poisson ratio worth trying.
inline std::vector<NamedLaw> laws() {
  const double modulus = 8.03368;
  std::vector<NamedLaw> all;
  const auto add = [&](const std::string& name, const Law& law) {
    const double nu = std::visit([](const auto& l) { return l.nu; }, law);
    all.push_back({name + ", nu = " + std::to_string(nu), law});
  };
  for (double nu : {0.0, 0.19, 0.45, -0.158}) {
    add("St Venant-Kirchhoff", StVenantKirchhoff{modulus, nu});
    add("Lee", LeeGraphene{modulus, nu, -2 * modulus});
    add("neo-Hookean", neo_hookean(modulus, nu));
    add("Mooney-Rivlin", MooneyRivlin{modulus, nu, 0.2});
  }
  add("incompressible neo-Hookean", neo_hookean(modulus, 0.5));
  add("incompressible Mooney-Rivlin", MooneyRivlin{modulus, 0.5, 0.2});
  add("Cauchy-Born", some_lattice());
  add("Cauchy-Born table", some_table());
  add("Cauchy-Born, sixfold", some_hexagonal_lattice(0));
  return all;
}

/// Calls visit(law) for each of laws(), inside a trace of its name.
template <class Visit>
void over_laws(Visit visit) {
  for (const auto& [name, any] : laws()) {
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
