#include "compare/fitting/membrane_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <stdexcept>

#include "compare/base/units.hpp"
#include "compare/fitting/curve.hpp"
#include "compare/fitting/fit.hpp"
#include "compare/fitting/models/list.hpp"
#include "membrane/problem.hpp"

namespace validate {
namespace {

constexpr double enclosing = 1.02;

/// Controlled depths, in equal ratios, whose depths of record enclose the given ones: the conjugate depth is
/// the smaller of the two, by half of it at most.
std::vector<double> levels_around(const std::vector<double>& depth, int count) {
  const double low = 0.5 * std::ranges::min(depth), high = enclosing * std::ranges::max(depth);
  std::vector<double> levels;
  for (int i = 0; i < count; ++i) levels.push_back(low * std::pow(high / low, i / (count - 1.0)));
  return levels;
}

membrane::Load load_of(const MembraneTip& tip) {
  if (!(tip.tip_A > 0)) return membrane::PointLoad{};
  if (tip.sphere) return membrane::SphereLoad{tip.tip_A};
  return membrane::DiscLoad{tip.tip_A};
}

membrane::Problem problem_of(const MembraneTip& tip, double Eh, double pretension, const std::vector<double>& depth,
                             int levels) {
  membrane::Problem problem;
  problem.discretisation = membrane::Meridian{};
  problem.sheet = membrane::DiscSheet{tip.a_A};
  problem.law = tip.physics ? tip.physics->law(Eh) : membrane::StVenantKirchhoff{Eh, tip.nu};
  problem.bending = membrane::clamped_all_round_if_any(tip.physics ? tip.physics->bending_eV : 0);
  problem.relaxed = !problem.bending;
  problem.prestress_eV_per_A2 = pretension * Eigen::Matrix2d::Identity();
  problem.load = load_of(tip);
  problem.record_radius_A = tip.record_radius_A;
  problem.levels = levels_around(depth, levels);
  return problem;
}

AnyCurveModel shallow_model(const MembraneTip& tip) {
  const bool sphere = tip.sphere && tip.tip_A > 0;
  return closed_form(sphere ? "sphere-pretension" : "foeppl", "").make({tip.a_A, tip.nu, tip.tip_A, 0});
}

/// Enough for a smooth ratio, and to see where a sheet that softens tears.
int levels_for(const MembraneTip& tip) { return tip.physics ? 64 : tip.sphere ? 32 : 16; }

/// Force of the membrane over force of the shallow one, interpolated in the depth: close to 1 and smooth.
class ForceRatio {
 public:
  ForceRatio(const MembraneTip& tip, double Eh, double pretension, const std::vector<double>& depth,
             const AnyCurveModel& shallow)
      : curve_(ratios(tip, Eh, pretension, depth, shallow)) {}

  /// Why the membrane's path ended before the deepest point; empty: it did not. Beyond it the ratio stays as
  /// it is, which is good enough for a first guess of E·h and pretension, not for the last.
  const std::string& ended_early() const { return ended_early_; }
  /// Where the path ended, Å.
  double deepest() const { return curve_.highest_A(); }

  double at(double depth) const {
    const auto ratio = curve_.at(std::clamp(depth, curve_.lowest_A(), curve_.highest_A()));
    return ratio.value_or(1);
  }

 private:
  Curve ratios(const MembraneTip& tip, double Eh, double pretension, const std::vector<double>& depth,
               const AnyCurveModel& shallow) {
    const double parameters[] = {Eh, pretension};
    std::vector<double> at, ratio;
    const membrane::Report report =
        membrane::solve(problem_of(tip, Eh, pretension, depth, levels_for(tip)), [&](const membrane::Step& step) {
          if (!step.converged) return false;
          at.push_back(step.depth_A);
          ratio.push_back(step.force_eV_per_A / shallow.value(step.depth_A, parameters));
          return true;
        });
    if (!report.converged) ended_early_ = "the membrane did not converge: " + report.reason;
    if (at.size() < 4) throw std::runtime_error(ended_early_);
    return Curve(at, ratio);
  }

  std::string ended_early_;  // before curve_, whose making sets it
  Curve curve_;
};

AnyCurveModel scaled(const AnyCurveModel& shallow, const ForceRatio& ratio) {
  return {shallow.parameter_count,
          [&](double d, std::span<const double> p) { return ratio.at(d) * shallow.value(d, p); },
          [&](double d, std::span<const double> p, std::span<double> g) {
            shallow.gradient(d, p, g);
            for (double& component : g) component *= ratio.at(d);
          }};
}

}  // namespace

SheetPhysics calibrated_physics(const membrane::CauchyBorn& law, double bending_eV, const std::string& potential) {
  const auto scaled_law = [law](double Eh) -> membrane::Law {
    membrane::CauchyBorn scaled = law;
    const double factor = Eh / law.sheet_modulus_eV_per_A2;
    scaled.sheet_modulus_eV_per_A2 = Eh;
    for (membrane::InvariantTerm& term : scaled.terms) term.coefficient_eV_per_A2 *= factor;
    return scaled;
  };
  return {scaled_law, bending_eV, fmt::format("sheet of {}'s own law, κ = {:.3g} eV", potential, bending_eV)};
}

SheetPhysics third_order_physics(double nu, double D, double bending_eV) {
  return {[nu, D](double Eh) -> membrane::Law {
            return membrane::LeeGraphene{Eh, nu, D};
          },
          bending_eV,
          fmt::format("sheet of third order, D = {:.4g} N/m, κ = {:.3g} eV", D * N_per_m_per_eV_per_A2, bending_eV),
          fitted_third_order};
}

std::vector<double> membrane_forces(const MembraneTip& tip, double Eh, double pretension,
                                    const std::vector<double>& depth) {
  const AnyCurveModel shallow = shallow_model(tip);
  const ForceRatio ratio(tip, Eh, pretension, depth, shallow);
  if (!ratio.ended_early().empty()) throw std::runtime_error(ratio.ended_early());
  const double parameters[] = {Eh, pretension};
  std::vector<double> force;
  for (const double d : depth) force.push_back(ratio.at(d) * shallow.value(d, parameters));
  return force;
}

SheetCurve sheet_curve(const MembraneTip& tip, const membrane::Law& law, double pretension,
                       const std::vector<double>& depth) {
  membrane::Problem problem = problem_of(tip, 1, pretension, depth, 2);
  problem.law = law;
  constexpr int parts = 5;  // between the depths asked for, so that the solver keeps to its path
  problem.levels.clear();
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const double before = i == 0 ? 0 : depth[i - 1];
    for (int k = 1; k <= parts; ++k)
      problem.levels.push_back(std::lerp(before, depth[i], static_cast<double>(k) / parts));
  }
  SheetCurve curve;
  const membrane::Report report = membrane::solve(problem, [&](const membrane::Step& step) {
    if (!step.converged) return false;
    if ((step.level + 1) % parts != 0) return true;
    curve.depth_A.push_back(step.depth_A);
    curve.force_eV_per_A.push_back(step.force_eV_per_A);
    return true;
  });
  if (!report.converged) curve.ended_early = report.reason;
  return curve;
}

namespace {

/// What is fitted: a curve's points, and their weights if they have any.
struct Points {
  std::vector<double> depth, force, weights;

  void keep_up_to(double deepest) {
    Points kept;
    for (std::size_t i = 0; i < depth.size(); ++i) {
      if (depth[i] > deepest) continue;
      kept.depth.push_back(depth[i]);
      kept.force.push_back(force[i]);
      if (!weights.empty()) kept.weights.push_back(weights[i]);
    }
    *this = std::move(kept);
  }
};

LeastSquaresReport fitted(const AnyCurveModel& model, const Points& points, const std::vector<double>& start) {
  LeastSquaresOptions options;
  options.weights = points.weights;
  return least_squares(model, points.depth, points.force, start, options);
}

bool settled(const std::vector<double>& before, const LeastSquaresReport& fit) {
  constexpr double same = 1e-5;
  const double largest = std::max(std::abs(fit.parameters[1]), 1e-3 * fit.standard_errors[1]);
  return std::abs(fit.parameters[0] - before[0]) <= same * fit.parameters[0] &&
         std::abs(fit.parameters[1] - before[1]) <= same * largest + 1e-9 * fit.parameters[0];
}

void report_fit(const MembraneTip& tip, const Points& points, const LeastSquaresReport& found, Fit& fit) {
  fit.model = tip.physics ? tip.physics->model : fitted_membrane;
  fit.Eh_eV_per_A2 = found.parameters[0];
  fit.Eh_stderr_eV_per_A2 = found.standard_errors[0];
  fit.pretension_eV_per_A2 = found.parameters[1];
  fit.pretension_stderr_eV_per_A2 = found.standard_errors[1];
  fit.rms_relative = rms(found.residuals) / std::ranges::max(points.force);
  fit.window_A = {std::ranges::min(points.depth), std::ranges::max(points.depth)};
  fit.points = static_cast<int>(points.depth.size());
  fit.fitted_depth_A = points.depth;
  fit.residual_eV_per_A = found.residuals;
  for (std::size_t i = 0; i < points.force.size(); ++i)
    fit.model_force_eV_per_A.push_back(points.force[i] - found.residuals[i]);
}

}  // namespace

MembraneFitReport fit_membrane(const MembraneTip& tip, const std::vector<double>& depth,
                               const std::vector<double>& force, const std::vector<double>& sigma) {
  constexpr int most_curves = 20;
  constexpr int first_guesses = 4;  // a wrong E·h may end early; the right one not
  MembraneFitReport result;
  Points points{depth, force, {}};
  for (const double s : sigma) points.weights.push_back(1 / (s * s));
  try {
    const AnyCurveModel shallow = shallow_model(tip);
    const auto deepest = static_cast<std::size_t>(std::ranges::max_element(depth) - depth.begin());
    std::vector<double> parameters = {1, 0};
    parameters[0] = force[deepest] / shallow.value(depth[deepest], parameters);
    LeastSquaresReport fit = fitted(shallow, points, parameters);
    for (result.iterations = 1; fit.converged && result.iterations <= most_curves; ++result.iterations) {
      parameters = fit.parameters;
      // A sheet with less than no tension everywhere has no flat state to start from.
      const ForceRatio ratio(tip, parameters[0], std::max(parameters[1], 0.0), points.depth, shallow);
      const bool torn = tip.physics && !ratio.ended_early().empty();
      if (torn) {
        result.fit.torn_at_A = ratio.deepest();
        points.keep_up_to(ratio.deepest() / enclosing);
      }
      fit = fitted(scaled(shallow, ratio), points, parameters);
      if (!fit.converged) break;
      if (torn) continue;
      result.reason = ratio.ended_early();
      if (!result.reason.empty() && result.iterations >= first_guesses) break;
      if (!settled(parameters, fit)) continue;
      result.converged = result.reason.empty();
      break;
    }
    if (!result.converged) {
      if (result.reason.empty()) result.reason = fit.converged ? "E·h and pretension did not settle" : fit.reason;
      return result;
    }
    report_fit(tip, points, fit, result.fit);
  } catch (const std::exception& problem) {
    result.reason = problem.what();
  }
  return result;
}

}  // namespace validate
