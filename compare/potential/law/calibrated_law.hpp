// The continuum law that a potential's homogeneous response amounts to (Cauchy–Born), and what is known of it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "atomistic/problem.hpp"
#include "atomistic/response.hpp"
#include "compare/potential/law/states.hpp"
#include "membrane/laws/cauchy_born.hpp"
#include "membrane/laws/cauchy_born_sixfold.hpp"

namespace validate {

/// Longest bond of a homogeneously strained lattice, whatever the strain's direction: l0 + Σ b I^a q^b, I = E1 + E2,
/// q = |E1 − E2|/2.
struct LongestBond {
  struct Term {
    int a = 0, b = 0;
    double coefficient_A = 0;
  };
  double rest_A = 0;  ///< l0
  std::vector<Term> terms;
  double worst_misfit_A = 0;

  double operator()(double E1, double E2) const;
};

/// A state beside the law's answer in its principal axes.
struct CalibratedState {
  atomistic::HomogeneousState atoms;
  double law_S1_eV_per_A2 = 0, law_S2_eV_per_A2 = 0;
  bool fitted = false;  ///< 15° from zigzag, longest bond within what is fitted
};

/// Where dS/dE has the smallest eigenvalue within the range of the law.
struct Convexity {
  double smallest_eigenvalue_eV_per_A2 = 0;
  double E1 = 0, E2 = 0;
  bool convex() const { return smallest_eigenvalue_eV_per_A2 > 0; }
};

struct CalibratedLaw {
  membrane::CauchyBorn law;
  membrane::CauchyBornSixfold sixfold;  ///< the same with the lattice's directions; no terms: not calibrated
  int degree = 0;
  std::vector<double> standard_errors_eV_per_A2;  ///< of law.terms
  double condition_number = 0;
  double worst_misfit = 0, rms_misfit = 0;  ///< |S_law − S_atoms| / √(S1² + S2² + (0.1 eV/Å²)²), fitted states
  double anisotropy = 0;  ///< largest difference of the stress along zigzag or armchair from that between, the same way
  std::vector<CalibratedState> states;
  LongestBond longest_bond;
  Convexity convexity;
  CalibrationRange range;
  double smallest_strain = 0;  ///< E2 of the fitted states

  /// True where the law was fitted: compressed no further, longest bond up to where it holds.
  bool within(double E1, double E2) const;
};

/// Degree 6 leaves up to 0.8 % of AIREBO's stress, 7 a third and 8 a tenth of that.
inline constexpr int default_degree = 8;

/// Least squares on the principal membrane forces of the states at 15° from zigzag, weighted by
/// 1/√(S1² + S2² + (0.1 eV/Å²)²), with the card's C11 and C12 held: terms c_ab I^a q^b of 3 ≤ a + b ≤ degree (at most
/// membrane::CauchyBorn::highest_degree), b ≠ 1. Throws
/// std::invalid_argument where the states that have converged are too few.
CalibratedLaw calibrate(const atomistic::Card& card, const std::vector<atomistic::HomogeneousState>& states,
                        const CalibrationRange& range, int degree = default_degree);

}  // namespace validate
