#include "compare/fitting/design.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "compare/base/units.hpp"
#include "compare/fitting/measured_fit.hpp"

namespace validate {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Points along the way of the piezo, without noise.
CurvePoints points_of(const Experiment& e, const ForceModel& model) {
  const ForceCurve sheet = curve_of(model, e.Eh_eV_per_A2, e.pretension_eV_per_A2);
  const double compliance = e.options.spring_constant_eV_per_A2 ? 1 / *e.options.spring_constant_eV_per_A2 : 0;
  const double last = e.depth_A + compliance * sheet(e.depth_A).value.force, first = -e.before * last;
  CurvePoints points;
  points.compliance_A2_per_eV = compliance;
  points.noise.force_eV_per_A = e.noise_eV_per_A;
  points.noise.depth_A = e.height_noise_A;
  double depth = 0;
  for (int i = 0; i < e.points; ++i) {
    const double z = std::lerp(first, last, i / (e.points - 1.0));
    double force = 0;
    if (z > 0) {
      // Newton's method from the point before, the force being convex.
      depth = std::max(depth, 1e-6 * last);
      for (int step = 0; step < 50; ++step) {
        const ForceAlong at = sheet(depth);
        const double change = (z - depth - compliance * at.value.force) / (1 + compliance * at.first.force);
        depth = std::max(depth + change, 1e-9 * last);
        if (std::abs(change) < 1e-10 * last) break;
      }
      force = sheet(depth).value.force;
    }
    points.depth_A.push_back(z > 0 ? depth : z);
    points.force_eV_per_A.push_back(force);
  }
  return points;
}

/// Of E·h and the inputs' z (shared), and of the rest (a curve's own).
struct Parts {
  MatrixXd shared, across, own;

  Parts(const Likelihood& likelihood, const MatrixXd& hessian) {
    std::vector<int> common = {0}, rest;
    const int first = likelihood.first_input(), inputs = static_cast<int>(likelihood.inputs().size());
    for (int i = 1; i < likelihood.parameter_count(); ++i)
      (i >= first && i < first + inputs ? common : rest).push_back(i);
    shared = hessian(common, common);
    across = hessian(common, rest);
    own = hessian(rest, rest);
  }

  /// Of all curves of a drum together, each z's own knowledge counted once.
  MatrixXd joint(int curves) const {
    MatrixXd sum = curves * (shared - across * own.ldlt().solve(across.transpose()));
    for (Eigen::Index i = 1; i < sum.rows(); ++i) sum(i, i) -= 2.0 * (curves - 1);
    return sum;
  }
};

DesignRow row_of_experiment(const Experiment& e, std::string what) {
  DesignRow row;
  row.what = std::move(what);
  row.radius_A = e.options.geometry.a_A;
  row.tip_radius_A = e.options.geometry.tip_A;
  row.spring_constant_eV_per_A2 = e.options.spring_constant_eV_per_A2.value_or(not_known);
  row.depth_A = e.depth_A;
  row.noise_eV_per_A = e.noise_eV_per_A;
  row.points = e.points;
  row.curves = e.curves;
  return row;
}

}  // namespace

DesignRow expected(const Experiment& e, std::string what) {
  DesignRow row = row_of_experiment(e, std::move(what));
  const SheetModel sheet =
      sheet_model(e.options, std::nullopt,
                  {1.05 * e.depth_A, e.Eh_eV_per_A2, 1.3 * std::max(e.pretension_eV_per_A2, 0.0) / e.Eh_eV_per_A2});
  const CurvePoints points = points_of(e, sheet.model);
  row.force_eV_per_A = points.force_eV_per_A.back();
  Likelihood likelihood(points, sheet.model, {true, true, true}, sheet.inputs);
  VectorXd theta = VectorXd::Zero(likelihood.parameter_count());
  theta[0] = e.Eh_eV_per_A2;
  theta[1] = e.pretension_eV_per_A2;
  likelihood.take_slopes(theta);
  const Likelihood::At at = likelihood.at(theta);
  const Parts parts(likelihood, at.information - at.excess);
  const MatrixXd joint = parts.joint(e.curves), covariance = 2 * joint.inverse();
  const MatrixXd inverse = parts.own.inverse(), carried = inverse * parts.across.transpose();
  const double numerical = sheet.model.relative_error * e.Eh_eV_per_A2;
  row.Eh_stderr_eV_per_A2 = std::hypot(std::sqrt(covariance(0, 0)), numerical);
  row.Eh_stderr_relative = row.Eh_stderr_eV_per_A2 / e.Eh_eV_per_A2;
  row.pretension_stderr_eV_per_A2 = std::sqrt(2 * inverse(0, 0) + (carried * covariance * carried.transpose())(0, 0));
  // A curve's own pretension follows what E·h and an input are moved by.
  const auto source = [&](std::string name, const VectorXd& moved) {
    row.sources.push_back({std::move(name), std::abs(moved[0]), std::abs((carried * moved)(0))});
  };
  VectorXd noise = VectorXd::Zero(joint.rows());
  noise[0] = std::sqrt(2 / joint(0, 0));
  source("noise", noise);
  row.sources.back().pretension_eV_per_A2 = std::sqrt(2 * inverse(0, 0) + std::pow((carried * noise)(0), 2));
  for (std::size_t k = 0; k < sheet.inputs.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k) + 1;
    VectorXd moved = VectorXd::Zero(joint.rows());
    moved[0] = -joint(0, i) / joint(0, 0);
    moved[i] = 1;
    source(sheet.inputs[k].name, moved);
  }
  std::ranges::sort(row.sources, std::greater{}, &ErrorSource::Eh_eV_per_A2);
  row.reaches = e.target && row.Eh_stderr_relative <= *e.target;
  return row;
}

namespace {

/// One thing that can be changed, by a factor from 1 to `most`.
struct Lever {
  std::string name;
  double most;
  std::function<void(Experiment&, double)> change;
};

/// Deeper than a quarter of its radius no sheet of this kind is pressed.
constexpr double deepest_share = 0.25;

std::vector<Lever> levers_of(const Experiment& e) {
  std::vector<Lever> all = {
      {"hole {:.3g} times as wide, pressed to the same share of it", 5,
       [](Experiment& x, double f) {
         x.options.geometry.a_A *= f;
         x.depth_A *= f;
       }},
      {"{:.3g} times as deep", deepest_share * e.options.geometry.a_A / e.depth_A,
       [](Experiment& x, double f) { x.depth_A *= f; }},
      {"noise of the force {:.3g} times less", 10, [](Experiment& x, double f) { x.noise_eV_per_A /= f; }},
      {"{:.3g} times as many points", 20,
       [](Experiment& x, double f) { x.points = static_cast<int>(std::lround(x.points * f)); }},
      {"{:.3g} times as many curves", 100,
       [](Experiment& x, double f) { x.curves = static_cast<int>(std::ceil(x.curves * f - 1e-9)); }},
  };
  const auto known_better = [&](const char* name, const auto& member) {
    Experiment copy = e;
    if (member(copy) > 0) all.push_back({name, 10, [member](Experiment& x, double f) { member(x) /= f; }});
  };
  known_better("spring constant known {:.3g} times better",
               [](Experiment& x) -> double& { return x.options.errors.force_scale_relative; });
  known_better("sensitivity known {:.3g} times better",
               [](Experiment& x) -> double& { return x.options.errors.sensitivity_relative; });
  known_better("radius known {:.3g} times better",
               [](Experiment& x) -> double& { return x.options.errors.geometry.a_A; });
  known_better("tip known {:.3g} times better",
               [](Experiment& x) -> double& { return x.options.errors.geometry.tip_A; });
  known_better("nu known {:.3g} times better", [](Experiment& x) -> double& { return x.options.errors.geometry.nu; });
  if (e.options.errors.force_scale_relative > 0 && e.options.errors.geometry.a_A > 0)
    all.push_back({"all inputs known {:.3g} times better", 10, [](Experiment& x, double f) {
                     InputErrors& errors = x.options.errors;
                     for (double* error : {&errors.force_scale_relative, &errors.sensitivity_relative,
                                           &errors.geometry.a_A, &errors.geometry.tip_A, &errors.geometry.nu})
                       *error /= f;
                   }});
  return all;
}

DesignRow changed(const Experiment& e, const Lever& lever, double factor) {
  Experiment other = e;
  lever.change(other, factor);
  return expected(other, fmt::format(fmt::runtime(lever.name), factor));
}

/// The least factor that reaches the target, or the largest there is.
DesignRow towards_target(const Experiment& e, const Lever& lever) {
  constexpr int halvings = 7;
  DesignRow best = changed(e, lever, lever.most);
  if (!best.reaches) return best;
  double low = 1, high = lever.most;
  for (int i = 0; i < halvings; ++i) {
    const double middle = std::sqrt(low * high);
    if (DesignRow row = changed(e, lever, middle); row.reaches)
      high = middle, best = std::move(row);
    else
      low = middle;
  }
  return best;
}

}  // namespace

Design design(const Experiment& e) {
  Design result;
  result.Eh_eV_per_A2 = e.Eh_eV_per_A2;
  result.pretension_eV_per_A2 = e.pretension_eV_per_A2;
  result.nu = e.options.geometry.nu;
  result.target_relative = e.target.value_or(not_known);
  result.rows.push_back(expected(e, "as asked for"));
  if (result.rows.front().reaches) return result;
  for (const Lever& lever : levers_of(e)) {
    if (!(lever.most > 1)) continue;
    constexpr double twice = 2;
    result.rows.push_back(e.target ? towards_target(e, lever) : changed(e, lever, std::min(twice, lever.most)));
  }
  return result;
}

}  // namespace validate
