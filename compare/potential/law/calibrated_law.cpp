#include "compare/potential/law/calibrated_law.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "compare/potential/law/linear_fit.hpp"

namespace validate {
namespace {

using atomistic::HomogeneousState;

double I_of(const HomogeneousState& s) { return s.strain.E11 + s.strain.E22; }
double q_of(const HomogeneousState& s) { return std::abs(s.strain.E11 - s.strain.E22) / 2; }

std::pair<double, double> forces_of(const membrane::CauchyBorn& law, const HomogeneousState& s) {
  const auto at = membrane::principal_response(law, s.strain.E11, s.strain.E22);
  return {at.S1, at.S2};
}

double misfit_of(const CalibratedState& s) {
  return std::hypot(s.law_S1_eV_per_A2 - s.atoms.S11_eV_per_A2, s.law_S2_eV_per_A2 - s.atoms.S22_eV_per_A2) /
         size_of(s.atoms);
}

/// Powers (a, b) of I and q.
std::vector<std::pair<int, int>> exponents(int lowest_degree, int highest_degree, bool linear_in_q) {
  std::vector<std::pair<int, int>> powers;
  for (int degree = lowest_degree; degree <= highest_degree; ++degree)
    for (int b = 0; b <= degree; ++b)
      if (b != 1 || linear_in_q) powers.emplace_back(degree - b, b);
  return powers;
}

/// Coefficients of the terms, from the forces that the quadratic part leaves over: two rows a state.
LinearFit fit_terms(const membrane::CauchyBorn& quadratic, const std::vector<const HomogeneousState*>& fitted,
                    const std::vector<std::pair<int, int>>& powers) {
  const auto rows = static_cast<Eigen::Index>(2 * fitted.size());
  Eigen::MatrixXd X(rows, static_cast<Eigen::Index>(powers.size()));
  Eigen::VectorXd y(rows), weights(rows);
  Eigen::Index row = 0;
  for (const HomogeneousState* s : fitted) {
    const auto [S1, S2] = forces_of(quadratic, *s);
    y[row] = s->S11_eV_per_A2 - S1;
    y[row + 1] = s->S22_eV_per_A2 - S2;
    weights[row] = weights[row + 1] = 1 / (size_of(*s) * size_of(*s));
    Eigen::Index column = 0;
    for (const auto& [a, b] : powers) {
      const double W_I = a > 0 ? a * std::pow(I_of(*s), a - 1) * std::pow(q_of(*s), b) : 0;
      const double half_W_q = b > 0 ? 0.5 * b * std::pow(I_of(*s), a) * std::pow(q_of(*s), b - 1) : 0;
      X(row, column) = W_I + half_W_q;
      X(row + 1, column++) = W_I - half_W_q;
    }
    row += 2;
  }
  return linear_fit(X, y, weights);
}

constexpr double longest_of_use_A = 1.75;  // beyond, a bond is on its way to break

/// The longest bond of every pair of principal strains over the directions computed, where the lattice bears all three.
LongestBond fit_longest_bond(double rest_A, const std::vector<HomogeneousState>& states, double up_to_A) {
  const int degree = up_to_A > longest_of_use_A ? 4 : 3;  // of 3 left 0.02 Å up to 1.9 Å, 4 leaves 0.005 Å
  std::map<std::pair<double, double>, double> longest;
  for (const HomogeneousState& s : states) {
    double& bond = longest[{s.strain.E11, s.strain.E22}];
    bond = std::max(bond, s.converged ? s.longest_bond_A : std::numeric_limits<double>::infinity());
  }
  std::erase_if(longest, [&](const auto& entry) { return entry.second > up_to_A; });
  const auto powers = exponents(1, degree, true);
  const auto rows = static_cast<Eigen::Index>(longest.size());
  Eigen::MatrixXd X(rows, static_cast<Eigen::Index>(powers.size()));
  Eigen::VectorXd y(rows);
  Eigen::Index row = 0;
  for (const auto& [strain, bond] : longest) {
    const double I = strain.first + strain.second, q = (strain.first - strain.second) / 2;
    for (Eigen::Index k = 0; k < X.cols(); ++k) {
      const auto& [a, b] = powers[static_cast<std::size_t>(k)];
      X(row, k) = std::pow(I, a) * std::pow(q, b);
    }
    y[row++] = bond - rest_A;
  }
  const LinearFit fit = linear_fit(X, y, Eigen::VectorXd::Ones(rows));
  LongestBond found{.rest_A = rest_A, .terms = {}};
  for (Eigen::Index k = 0; k < X.cols(); ++k)
    found.terms.push_back(
        {powers[static_cast<std::size_t>(k)].first, powers[static_cast<std::size_t>(k)].second, fit.coefficients[k]});
  found.worst_misfit_A = (X * fit.coefficients - y).cwiseAbs().maxCoeff();
  return found;
}

Convexity convexity_of(const CalibratedLaw& calibrated, double largest_strain) {
  constexpr int parts = 60;
  Convexity worst{.smallest_eigenvalue_eV_per_A2 = std::numeric_limits<double>::infinity()};
  const auto strain = [&](int i) { return std::lerp(calibrated.smallest_strain, largest_strain, i / double(parts)); };
  for (int i = 0; i <= parts; ++i) {
    for (int j = 0; j <= i; ++j) {
      const double E1 = strain(i), E2 = strain(j);
      if (!calibrated.within(E1, E2)) continue;
      const Eigen::Matrix3d tangent = calibrated.law({E1, E2, 0}).tangent_eV_per_A2;
      const double smallest = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(tangent).eigenvalues()[0];
      if (smallest < worst.smallest_eigenvalue_eV_per_A2) worst = {smallest, E1, E2};
    }
  }
  return worst;
}

/// How far the forces along zigzag and armchair are from those in between, over the states that all three have.
double anisotropy_of(const std::vector<CalibratedState>& states, double up_to_A) {
  std::map<std::pair<double, double>, const HomogeneousState*> between;
  for (const CalibratedState& s : states)
    if (s.fitted) between[{s.atoms.strain.E11, s.atoms.strain.E22}] = &s.atoms;
  double largest = 0;
  for (const CalibratedState& s : states) {
    const auto found = between.find({s.atoms.strain.E11, s.atoms.strain.E22});
    if (found == between.end() || s.atoms.longest_bond_A > up_to_A) continue;
    const double difference = std::hypot(s.atoms.S11_eV_per_A2 - found->second->S11_eV_per_A2,
                                         s.atoms.S22_eV_per_A2 - found->second->S22_eV_per_A2);
    largest = std::max(largest, difference / size_of(*found->second));
  }
  return largest;
}

void judge_misfit(CalibratedLaw& calibrated) {
  double squares = 0;
  int count = 0;
  for (CalibratedState& s : calibrated.states) {
    std::tie(s.law_S1_eV_per_A2, s.law_S2_eV_per_A2) = forces_of(calibrated.law, s.atoms);
    if (!s.fitted) continue;
    calibrated.worst_misfit = std::max(calibrated.worst_misfit, misfit_of(s));
    squares += misfit_of(s) * misfit_of(s);
    ++count;
  }
  calibrated.rms_misfit = std::sqrt(squares / count);
}

}  // namespace

double LongestBond::operator()(double E1, double E2) const {
  const double I = E1 + E2, q = std::abs(E1 - E2) / 2;
  double bond = rest_A;
  for (const Term& t : terms) bond += t.coefficient_A * std::pow(I, t.a) * std::pow(q, t.b);
  return bond;
}

bool CalibratedLaw::within(double E1, double E2) const {
  constexpr double rounding = 1e-12;
  return std::min(E1, E2) >= smallest_strain - rounding && longest_bond(E1, E2) <= range.holds_A;
}

CalibratedLaw calibrate(const atomistic::Card& card, const std::vector<HomogeneousState>& states,
                        const CalibrationRange& range, int degree) {
  CalibratedLaw calibrated;
  calibrated.degree = degree;
  calibrated.range = range;
  for (const HomogeneousState& s : states) {
    if (!s.converged) continue;
    const bool averaged = s.strain.orientation_deg == averaged_deg;
    calibrated.states.push_back({s, 0, 0, averaged && s.longest_bond_A <= range.fitted_A});
  }
  std::vector<const HomogeneousState*> fitted;
  double largest_strain = 0;
  for (const CalibratedState& s : calibrated.states) {
    if (!s.fitted) continue;
    fitted.push_back(&s.atoms);
    calibrated.smallest_strain = std::min(calibrated.smallest_strain, s.atoms.strain.E22);
    largest_strain = std::max(largest_strain, s.atoms.strain.E11);
  }
  calibrated.law = {card.sheet_modulus_eV_per_A2(), card.nu(), {}};
  const auto powers = exponents(3, degree, false);
  const LinearFit fit = fit_terms(calibrated.law, fitted, powers);
  for (std::size_t k = 0; k < powers.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    calibrated.law.terms.push_back({powers[k].first, powers[k].second, fit.coefficients[at]});
    calibrated.standard_errors_eV_per_A2.push_back(fit.standard_errors[at]);
  }
  calibrated.condition_number = fit.condition_number;
  judge_misfit(calibrated);
  calibrated.longest_bond =
      fit_longest_bond(card.a0_A / std::numbers::sqrt3, states, std::max(longest_of_use_A, range.fitted_A));
  calibrated.convexity = convexity_of(calibrated, largest_strain);
  calibrated.anisotropy = anisotropy_of(calibrated.states, range.holds_A);
  return calibrated;
}

}  // namespace validate
