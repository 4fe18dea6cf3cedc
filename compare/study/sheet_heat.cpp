#include "compare/study/sheet_heat.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "atomistic/vibration.hpp"
#include "compare/fitting/curve.hpp"
#include "compare/potential/law/linear_fit.hpp"
#include "compare/study/drum_waves.hpp"

namespace validate {
namespace {

using membrane::MeridianPoint;

/// The neighbours of a central difference, as a share of the depth.
constexpr double share_of_depth = 0.02;

/// The sheet at one depth.
struct WarmPlace {
  double depth = 0, force = 0;
  double cell_eV = 0, waves_eV = 0;
};

double integral(const std::vector<MeridianPoint>& points, const VibrationLaw& law) {
  double sum = 0;
  for (std::size_t k = 1; k < points.size(); ++k) {
    const MeridianPoint &p = points[k - 1], &q = points[k];
    const double inner = law(p.radial_strain, p.hoop_strain) * p.radius_A;
    const double outer = law(q.radial_strain, q.hoop_strain) * q.radius_A;
    sum += std::numbers::pi * (inner + outer) * (q.radius_A - p.radius_A);
  }
  return sum;
}

/// The sheet's own path at these depths; what it does not reach is missing.
std::map<double, WarmPlace> follow(const ContinuumExperiment& sheet, const std::vector<double>& depths,
                                   const VibrationLaw& law, const DrumWaves& waves) {
  membrane::Problem problem = sheet.problem;
  problem.control = membrane::Control::conjugate_depth;
  problem.levels = depths;
  std::map<double, WarmPlace> places;
  membrane::solve(problem, [&](const membrane::Step& step) {
    if (!step.converged) return false;
    places[depths[static_cast<std::size_t>(step.level)]] = {
        step.conjugate_depth_A, step.force_eV_per_A, integral(step.on_meridian(), law), waves(step.on_meridian())};
    return true;
  });
  return places;
}

struct WarmShift {
  double by_cell = not_known, by_waves = not_known;
  double force_ratio = not_known;  ///< of the sheet at equal depth
  double force = not_known;        ///< at T = 0
};

/// Shifts at held force are −dΦ/dF; at held depth the vibration along the depth itself is missing, ½ kT d ln(dd/dF)/dd.
WarmShift shift_at(const WarmPlace& before, const WarmPlace& here, const WarmPlace& after,
                   const atomistic::Heat& heat) {
  const double d_force = after.force - before.force, compliance = (after.depth - before.depth) / d_force;
  const double softer = std::log((after.depth - here.depth) / (after.force - here.force)) -
                        std::log((here.depth - before.depth) / (here.force - before.force));
  const double held =
      atomistic::constants::boltzmann_eV_per_K * heat.temperature_K * softer / (after.depth - before.depth);
  WarmShift shift{-(after.cell_eV - before.cell_eV) / d_force, -(after.waves_eV - before.waves_eV) / d_force, not_known,
                  here.force};
  shift.force_ratio = 1 + (held - (shift.by_cell + shift.by_waves) / compliance) / here.force;
  return shift;
}

/// None where too few states are stable.
std::optional<VibrationLaw> law_of(const WarmPotential& warm) {
  try {
    return VibrationLaw(warm);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

std::vector<double> with_neighbours(const std::vector<double>& depths) {
  std::vector<double> all;
  for (const double depth : depths)
    for (const double factor : {1 - share_of_depth, 1.0, 1 + share_of_depth}) all.push_back(factor * depth);
  std::ranges::sort(all);
  return all;
}

/// The force of the sheet at the atoms' depth of record over that of the atoms is the run's own ratio of both curves.
std::optional<double> cold_ratio(const Run& atoms, const Run& sheet, std::size_t i) {
  try {
    if (const auto force = Curve(sheet).at(atoms.depth_A[i])) return atoms.force_eV_per_A[i] / *force;
  } catch (const std::invalid_argument&) {  // no curve
  }
  return std::nullopt;
}

}  // namespace

std::vector<atomistic::StrainState> warm_strains(const PotentialCard& card) {
  std::vector<atomistic::StrainState> strains =
      calibration_strains(card.card.bond_A(), calibration_range(card.potential.potential.artefact_bond_A));
  std::erase_if(strains, [](const atomistic::StrainState& s) { return s.orientation_deg != averaged_deg; });
  return strains;
}

VibrationLaw::VibrationLaw(const WarmPotential& warm) {
  constexpr int degree = 5;
  for (int a = 0; a <= degree; ++a)
    for (int b = 0; a + b <= degree; ++b)
      if (a + b > 0) terms_.push_back({a, b});
  std::vector<std::size_t> stable;
  for (std::size_t i = 0; i < warm.strains.size(); ++i)
    if (std::isfinite(warm.free_energy_eV_per_A2[i])) stable.push_back(i);
  const auto rows = static_cast<Eigen::Index>(stable.size()), columns = static_cast<Eigen::Index>(terms_.size());
  Eigen::MatrixXd X(rows, columns);
  Eigen::VectorXd y(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const atomistic::StrainState& s = warm.strains[stable[static_cast<std::size_t>(i)]];
    const double I = s.E11 + s.E22, q = std::abs(s.E11 - s.E22) / 2;
    for (Eigen::Index k = 0; k < columns; ++k) {
      const Term& term = terms_[static_cast<std::size_t>(k)];
      X(i, k) = std::pow(I, term.a) * std::pow(q, term.b);
    }
    y[i] = warm.free_energy_eV_per_A2[stable[static_cast<std::size_t>(i)]];
  }
  const Eigen::VectorXd c = linear_fit(X, y, Eigen::VectorXd::Ones(rows)).coefficients;
  coefficients_.assign(c.data(), c.data() + c.size());
  misfit_ = (X * c - y).norm() / std::sqrt(static_cast<double>(rows)) / (y.maxCoeff() - y.minCoeff());
}

double VibrationLaw::operator()(double E1, double E2) const {
  const double I = E1 + E2, q = std::abs(E1 - E2) / 2;
  double sum = 0;
  for (std::size_t k = 0; k < terms_.size(); ++k)
    sum += coefficients_[k] * std::pow(I, terms_[k].a) * std::pow(q, terms_[k].b);
  return sum;
}

void heat_sheet(PairedLoad& load, const PotentialCard& card, const WarmPotential& warm, const atomistic::Heat& heat) {
  const ContinuumExperiment* sheet = load.find(Purpose::calibrated_sheet);
  if (!sheet || !load.atoms || !load.atoms->run.thermal || load.atoms->run.thermal->rim == Rim::thermal || !card.law)
    return;
  Run& run = load.atoms->run;
  Thermal& thermal = *run.thermal;
  const std::optional<VibrationLaw> law = law_of(warm);
  if (!law) return;
  const double slope_margin = std::get<membrane::DiscSheet>(sheet->problem.sheet).slope_margin_A;
  const DrumWaves waves({.a_A = sheet->run.a_A,
                         .slope_margin_A = slope_margin,
                         .bending_modulus_eV = card.card.bending_modulus_eV(),
                         .law = &card.law->law,
                         .area_per_atom_A2 = card.card.area_per_atom_A2(),
                         .mass_u = card.potential.potential.mass,
                         .shortest_wave_A = warm.card.longest_wave_A},
                        heat);
  std::vector<double> depths;
  for (const std::size_t i : usable_points(run))
    if (std::isfinite(thermal.depth_shift_A[i])) depths.push_back(run.conjugate_depth_A[i]);
  const auto places = follow(*sheet, with_neighbours(depths), *law, waves);
  const auto place = [&](double depth) -> const WarmPlace* {
    const auto found = places.find(depth);
    return found == places.end() ? nullptr : &found->second;
  };
  const std::size_t count = run.depth_A.size();
  for (auto* column : {&thermal.sheet_shift_by_cell_A, &thermal.sheet_shift_by_waves_A, &thermal.sheet_force_ratio})
    column->assign(count, not_known);
  for (std::size_t i = 0; i < count; ++i) {
    const double depth = run.conjugate_depth_A[i];
    const WarmPlace *before = place((1 - share_of_depth) * depth), *here = place(depth),
                    *after = place((1 + share_of_depth) * depth);
    if (!before || !here || !after) continue;
    const WarmShift shift = shift_at(*before, *here, *after, heat);
    thermal.sheet_shift_by_cell_A[i] = shift.by_cell;
    thermal.sheet_shift_by_waves_A[i] = shift.by_waves;
    if (const auto ratio = cold_ratio(run, sheet->run, i))
      thermal.sheet_force_ratio[i] = *ratio * thermal.force_ratio[i] / shift.force_ratio;
  }
}

}  // namespace validate
