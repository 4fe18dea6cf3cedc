#include "compare/study/uncertainty.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <stdexcept>
#include <variant>
#include <vector>

#include "compare/fitting/curve.hpp"
#include "compare/verdict/agreement.hpp"

namespace validate {
namespace {

/// Force (of a pressure: the pressure) over the depth of record; nothing where it cannot be solved.
std::optional<Curve> solved(const membrane::Problem& problem) {
  std::vector<double> depth, value;
  const bool pressed = std::holds_alternative<membrane::PressureLoad>(problem.load);
  try {
    membrane::solve(problem, [&](const membrane::Step& step) {
      if (!step.converged) return false;
      depth.push_back(step.depth_A);
      value.push_back(pressed ? step.pressure_eV_per_A3 : step.force_eV_per_A);
      return true;
    });
    return Curve(depth, value);
  } catch (const std::invalid_argument&) {  // no meridian, or no curve
    return std::nullopt;
  }
}

/// The continuum with one of its inputs another.
using Change = std::function<void(membrane::Problem&)>;

class Sensitivity {
 public:
  explicit Sensitivity(const membrane::Problem& problem) : problem_(problem) {
    problem_.discretisation = membrane::Meridian{};
    nominal_ = solved(problem_);
  }
  bool known() const { return nominal_.has_value(); }

  /// The curve as it was judged, triangles or meridian and interpolated, beside a meridian of half the elements'
  /// length.
  void add_mesh(std::vector<JudgedRatio>& ratios, const Run& judged_run) const {
    membrane::Problem fine = problem_;
    fine.discretisation = membrane::Meridian{.refinement = 2};
    const auto curve = solved(fine);
    if (!curve) return;
    const Curve used(judged_run);
    for (JudgedRatio& judged : ratios) {
      const auto here = used.at(judged.depth_A), there = curve->at(judged.depth_A);
      if (here && there) judged.shares.mesh = std::abs(*there / *here - 1);
    }
  }

  /// Relative change of the force at each depth, set into a share of the ratios.
  void add(std::vector<JudgedRatio>& ratios, double RatioShares::*share, const Change& change) const {
    membrane::Problem other = problem_;
    change(other);
    const auto curve = solved(other);
    if (!curve) return;
    for (JudgedRatio& judged : ratios) {
      const auto here = nominal_->at(judged.depth_A), there = curve->at(judged.depth_A);
      if (here && there) judged.shares.*share = std::abs(*there / *here - 1);
    }
  }

 private:
  membrane::Problem problem_;
  std::optional<Curve> nominal_;
};

membrane::DiscSheet& disc_of(membrane::Problem& problem) { return std::get<membrane::DiscSheet>(problem.sheet); }

void add_solved_shares(const Result& result, const Run& run, const ContinuumExperiment& continuum,
                       std::vector<JudgedRatio>& ratios) {
  const SheetSummary& sheet = *result.sheet;
  if (!std::holds_alternative<membrane::DiscSheet>(continuum.problem.sheet)) return;
  const Sensitivity sensitivity(continuum.problem);
  if (!sensitivity.known()) return;
  const bool bends = continuum.problem.bending.has_value();
  sensitivity.add_mesh(ratios, run);
  sensitivity.add(ratios, &RatioShares::clamp_radius,
                  [&](membrane::Problem& p) { disc_of(p).radius_A += sheet.clamp_radius_error_A; });
  if (bends)
    sensitivity.add(ratios, &RatioShares::slope_margin,
                    [&](membrane::Problem& p) { disc_of(p).slope_margin_A += sheet.slope_margin_error_A; });
  if (std::holds_alternative<membrane::DiscLoad>(continuum.problem.load))
    sensitivity.add(ratios, &RatioShares::tip_radius, [&](membrane::Problem& p) {
      std::get<membrane::DiscLoad>(p.load).radius_A += sheet.tip_radius_error_A;
    });
  if (bends && result.card) {
    const CardSummary& card = *result.card;
    const double error = std::abs(card.bending_modulus_zigzag_eV - card.bending_modulus_armchair_eV) / 2;
    const double factor = 1 + error / card.bending_modulus_eV;
    sensitivity.add(ratios, &RatioShares::bending_modulus, [&](membrane::Problem& p) {
      p.bending = membrane::clamped_all_round(factor * p.bending->mean_eV);
    });
  }
}

/// Where no meridian tells: a membrane's force goes as 1/a².
void add_plain_clamp(const Result& result, double a_A, std::vector<JudgedRatio>& ratios) {
  for (JudgedRatio& judged : ratios)
    if (judged.shares.clamp_radius == 0) judged.shares.clamp_radius = 2 * result.sheet->clamp_radius_error_A / a_A;
}

double error_of_atoms(const Run& atoms, double depth_A) {
  for (std::size_t i = 0; i < atoms.depth_A.size(); ++i)
    if (atoms.depth_A[i] == depth_A && i < atoms.atoms().force_error_relative.size() &&
        std::isfinite(atoms.atoms().force_error_relative[i]))
      return atoms.atoms().force_error_relative[i];
  return 0;
}

/// A hexagonal lattice has C66 = (C11 − C12)/2; where the card's differ, the shear modulus µ is somewhere between (a
/// uniform distribution), and E·h = 4 K µ/(K + µ) follows by (1 + ν)/2 of it.
double error_of_constants(const CardSummary& card) {
  return std::abs(card.isotropy_error) / std::sqrt(12.0) * (1 + card.nu) / 2;
}

}  // namespace

void add_uncertainties(Result& result, const PairedLoad& load) {
  if (!result.agreement || !result.sheet) return;
  Agreement& agreement = *result.agreement;
  const bool sheet = agreement.against == Model::sheet;
  const ContinuumExperiment* continuum = load.find(sheet ? Purpose::calibrated_sheet : Purpose::like_for_like);
  const auto atoms = std::ranges::find_if(
      result.runs, [&](const Run& run) { return run.is_atomistic() && run.load == agreement.load; });
  const auto run = std::ranges::find_if(result.runs, [&](const Run& other) {
    return other.model == agreement.against && other.load == agreement.load &&
           other.constants == (sheet ? Constants::calibrated : Constants::card);
  });
  if (!continuum || atoms == result.runs.end() || run == result.runs.end()) return;
  add_solved_shares(result, *run, *continuum, agreement.ratios);
  add_plain_clamp(result, atoms->a_A, agreement.ratios);
  for (JudgedRatio& judged : agreement.ratios) {
    RatioShares& shares = judged.shares;
    shares.minimiser = error_of_atoms(*atoms, judged.depth_A);
    if (result.card) shares.elastic_constants = error_of_constants(*result.card);
    if (sheet && result.law) shares.law = result.law->rms_misfit;
    judged.u_numerical = judged.ratio * std::hypot(shares.mesh, shares.minimiser);
    judged.u_input =
        judged.ratio * std::hypot(std::hypot(shares.clamp_radius, shares.slope_margin, shares.tip_radius),
                                  std::hypot(shares.bending_modulus, shares.elastic_constants, shares.law));
  }
  settle(agreement);
}

}  // namespace validate
