#include "compare/potential/law/variants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/potential/law/linear_fit.hpp"
#include "compare/potential/law/states.hpp"
#include "membrane/problem.hpp"

namespace validate {
namespace {

using atomistic::HomogeneousState;
using membrane::Voigt;

Voigt strain_of(const HomogeneousState& s) { return {s.strain.E11, s.strain.E22, 2 * s.strain.E12}; }
Voigt force_of(const HomogeneousState& s) { return {s.S11_eV_per_A2, s.S22_eV_per_A2, s.S12_eV_per_A2}; }

std::vector<const HomogeneousState*> usable(const std::vector<HomogeneousState>& states, const CalibrationRange& range,
                                            bool all_directions) {
  std::vector<const HomogeneousState*> found;
  for (const HomogeneousState& s : states)
    if (s.converged && s.longest_bond_A <= range.fitted_A &&
        (all_directions || s.strain.orientation_deg == averaged_deg))
      found.push_back(&s);
  return found;
}

/// Coefficients of a law that is linear in them: a column is what one of them alone adds to the membrane forces.
/// `at(coefficients, state)` is the law's force there.
template <class Force>
Eigen::VectorXd fit_linear_law(std::size_t count, const std::vector<const HomogeneousState*>& states, Force at) {
  const auto rows = static_cast<Eigen::Index>(3 * states.size()), columns = static_cast<Eigen::Index>(count);
  Eigen::MatrixXd X(rows, columns);
  Eigen::VectorXd y(rows), weights(rows);
  Eigen::VectorXd c = Eigen::VectorXd::Zero(columns);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(3 * i);
    const Voigt none = at(c, *states[i]);
    y.segment<3>(row) = force_of(*states[i]) - none;
    weights.segment<3>(row).setConstant(std::pow(size_of(*states[i]), -2));
    for (Eigen::Index k = 0; k < columns; ++k) {
      c[k] = 1;
      X.block<3, 1>(row, k) = at(c, *states[i]) - none;
      c[k] = 0;
    }
  }
  return least_norm_fit(X, y, weights);
}

template <class Force>
LawVariant variant(std::string name, std::size_t coefficients, const std::vector<const HomogeneousState*>& states,
                   Force at) {
  LawVariant v{std::move(name), coefficients, 0, 0, 0};
  for (const HomogeneousState* s : states) {
    const double misfit = (at(*s) - force_of(*s)).norm() / size_of(*s);
    v.rms_misfit += misfit * misfit / static_cast<double>(states.size());
    v.worst_misfit = std::max(v.worst_misfit, misfit);
  }
  v.rms_misfit = std::sqrt(v.rms_misfit);
  return v;
}

/// The probe: 110 Å, a disc of 10 Å.
constexpr double probe_radius_A = 110, probe_tip_A = 10;
std::vector<double> probe_depths() {
  std::vector<double> depths;
  for (int i = 1; i <= 5; ++i) depths.push_back(0.05 * i * probe_radius_A);
  return depths;
}

/// Forces at the levels, up to the first that is not reached.
std::vector<double> forces_of(const membrane::Problem& problem) {
  std::vector<double> forces;
  membrane::solve(problem, [&](const membrane::Step& step) {
    if (step.converged) forces.push_back(step.force_eV_per_A);
    return step.converged;
  });
  return forces;
}

std::vector<double> sheet_forces(const membrane::Law& law, double bending_eV) {
  membrane::Problem problem;
  problem.discretisation = membrane::Meridian{};
  problem.sheet = membrane::DiscSheet{probe_radius_A};
  problem.law = law;
  problem.relaxed = false;
  problem.bending = membrane::clamped_all_round_if_any(bending_eV);
  problem.load = membrane::DiscLoad{probe_tip_A};
  problem.levels = probe_depths();
  return forces_of(problem);
}

double largest_difference(const std::vector<double>& one, const std::vector<double>& other) {
  double largest = 0;
  for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i)
    largest = std::max(largest, std::abs(one[i] / other[i] - 1));
  return largest;
}

std::vector<double> triangle_forces(const membrane::Law& law, double radius_A, double tip_A,
                                    const std::vector<double>& depths_A) {
  membrane::Problem problem;
  constexpr int rings = 20;  // both membranes have the same mesh, whose error drops out of their ratio
  problem.sheet = membrane::DiscSheet{.radius_A = radius_A, .rings = rings};
  problem.law = law;
  problem.relaxed = false;
  problem.load = membrane::DiscLoad{tip_A};
  problem.levels = depths_A;
  return forces_of(problem);
}

/// The state's axes are turned from zigzag.
Voigt sixfold_force(membrane::CauchyBornSixfold law, const HomogeneousState& s) {
  law.zigzag_rad = -s.strain.orientation_deg * std::numbers::pi / 180;
  return law(strain_of(s)).force_eV_per_A2;
}

}  // namespace

membrane::CauchyBornTable calibrate_table(const atomistic::Card& card, const std::vector<HomogeneousState>& states,
                                          const CalibrationRange& range) {
  const auto fitted = usable(states, range, false);
  membrane::CauchyBornTable table{card.sheet_modulus_eV_per_A2(), card.nu(), {}, {}, {}};
  double least = 0, most = 0, shear = 0;
  for (const HomogeneousState* s : fitted) {
    least = std::min(least, s->strain.E11 + s->strain.E22);
    most = std::max(most, s->strain.E11 + s->strain.E22);
    shear = std::max(shear, (s->strain.E11 - s->strain.E22) / 2);
  }
  table.I = {least, most, 5};
  table.q = {0, shear, 3};
  const auto with = [&](const Eigen::VectorXd& c) {
    membrane::CauchyBornTable t = table;
    t.coefficients_eV_per_A2.assign(c.data(), c.data() + c.size());
    return t;
  };
  return with(fit_linear_law(static_cast<std::size_t>(table.coefficient_count()), fitted,
                             [&](const Eigen::VectorXd& c, const HomogeneousState& s) -> Voigt {
                               return with(c)(strain_of(s)).force_eV_per_A2;
                             }));
}

membrane::CauchyBornSixfold calibrate_sixfold(const atomistic::Card& card, const std::vector<HomogeneousState>& states,
                                              const CalibrationRange& range) {
  membrane::CauchyBornSixfold law{card.sheet_modulus_eV_per_A2(), card.nu(), 0, {}};
  const auto add = [&](membrane::Sixfold angle, int lowest_b, int highest_degree) {
    for (int degree = 3; degree <= highest_degree; ++degree)
      for (int b = lowest_b; b <= degree; ++b)
        if (b != 1) law.terms.push_back({degree - b, b, angle, 0});
  };
  add(membrane::Sixfold::none, 0, 8);
  add(membrane::Sixfold::cosine, 3, 8);
  add(membrane::Sixfold::cosine_squared, 6, 8);
  add(membrane::Sixfold::knots, 3, 7);
  const auto with = [&](const Eigen::VectorXd& c) {
    membrane::CauchyBornSixfold l = law;
    for (std::size_t k = 0; k < l.terms.size(); ++k) l.terms[k].coefficient_eV_per_A2 = c[static_cast<Eigen::Index>(k)];
    return l;
  };
  return with(
      fit_linear_law(law.terms.size(), usable(states, range, true),
                     [&](const Eigen::VectorXd& c, const HomogeneousState& s) { return sixfold_force(with(c), s); }));
}

std::vector<LawVariant> law_variants(const atomistic::Card& card, const std::vector<HomogeneousState>& states,
                                     const CalibrationRange& range) {
  const auto averaged = usable(states, range, false), all = usable(states, range, true);
  const auto isotropic = [](const auto& law) {
    return [&law](const HomogeneousState& s) -> Voigt {
      Voigt force = law(strain_of(s)).force_eV_per_A2;
      force[2] = s.S12_eV_per_A2;  // what the average over directions leaves out
      return force;
    };
  };
  const double bending = card.bending_modulus_eV();
  const membrane::CauchyBornTable table = calibrate_table(card, states, range);
  const std::vector<double> reference = sheet_forces(table, bending);
  std::vector<LawVariant> found;
  CalibratedLaw highest;
  for (int degree = 5; degree <= default_degree; ++degree) {
    highest = calibrate(card, states, range, degree);
    found.push_back(
        variant(fmt::format("degree {}", degree), highest.law.terms.size(), averaged, isotropic(highest.law)));
    found.back().force_difference = largest_difference(sheet_forces(highest.law, bending), reference);
  }
  found.push_back(variant("table", table.coefficients_eV_per_A2.size(), averaged, isotropic(table)));
  const membrane::CauchyBornSixfold sixfold = calibrate_sixfold(card, states, range);
  found.push_back(variant("sixfold", sixfold.terms.size(), all,
                          [&](const HomogeneousState& s) { return sixfold_force(sixfold, s); }));
  highest.sixfold = sixfold;
  for (const double ratio : anisotropy_ratios(highest, probe_radius_A, probe_tip_A, probe_depths()))
    found.back().force_difference = std::max(found.back().force_difference, std::abs(ratio - 1));
  return found;
}

std::vector<double> anisotropy_ratios(const CalibratedLaw& law, double radius_A, double tip_A,
                                      const std::vector<double>& depths_A) {
  const std::vector<double> with = triangle_forces(law.sixfold, radius_A, tip_A, depths_A);
  const std::vector<double> without = triangle_forces(law.law, radius_A, tip_A, depths_A);
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(with.size(), without.size()); ++i) ratios.push_back(with[i] / without[i]);
  return ratios;
}

}  // namespace validate
