#include "compare/fitting/sheet_physics.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "compare/base/units.hpp"

namespace validate {
namespace {

membrane::Load load_of(const MembraneTip& tip) {
  if (!(tip.tip_A > 0)) return membrane::PointLoad{};
  if (tip.sphere) return membrane::SphereLoad{tip.tip_A};
  return membrane::DiscLoad{tip.tip_A};
}

}  // namespace

SheetPhysics calibrated_physics(const membrane::CauchyBorn& law, double bending_eV, const std::string& potential,
                                double slope_margin_A) {
  const auto scaled_law = [law](double Eh) -> membrane::Law {
    membrane::CauchyBorn scaled = law;
    const double factor = Eh / law.sheet_modulus_eV_per_A2;
    scaled.sheet_modulus_eV_per_A2 = Eh;
    for (membrane::InvariantTerm& term : scaled.terms) term.coefficient_eV_per_A2 *= factor;
    return scaled;
  };
  return {scaled_law, true, bending_eV, slope_margin_A,
          fmt::format("sheet of {}'s own law, κ = {:.3g} eV", potential, bending_eV)};
}

SheetPhysics third_order_physics(double nu, double D, double bending_eV) {
  return {[nu, D](double Eh) -> membrane::Law {
            return membrane::LeeGraphene{Eh, nu, D};
          },
          false,
          bending_eV,
          0,
          fmt::format("sheet of third order, D = {:.4g} N/m, κ = {:.3g} eV", D * N_per_m_per_eV_per_A2, bending_eV),
          fitted_third_order};
}

double third_order_modulus(const membrane::CauchyBorn& law) {
  double product = 0, square = 0;
  for (int i = 1; i <= 10; ++i) {
    const double E = 0.005 * i, beyond = law.uniaxial(E).force_eV_per_A2 - law.sheet_modulus_eV_per_A2 * E;
    product += beyond * E * E;
    square += std::pow(E, 4);
  }
  return product / square;
}

membrane::Law law_of(const MembraneTip& tip, double Eh) {
  return tip.physics ? tip.physics->law(Eh) : membrane::StVenantKirchhoff{Eh, tip.nu};
}

membrane::Problem problem_of(const MembraneTip& tip, const membrane::Law& law, double pretension,
                             std::vector<double> depth) {
  membrane::Problem problem;
  problem.discretisation = membrane::Meridian{};
  membrane::DiscSheet sheet{tip.a_A};
  if (tip.bending_eV() > 0) sheet.slope_margin_A = tip.physics->slope_margin_A;
  problem.sheet = sheet;
  problem.law = law;
  problem.bending = membrane::clamped_all_round_if_any(tip.bending_eV());
  problem.relaxed = !problem.bending;
  problem.prestress_eV_per_A2 = pretension * Eigen::Matrix2d::Identity();
  problem.load = load_of(tip);
  problem.record_radius_A = tip.record_radius_A;
  problem.levels = std::move(depth);
  return problem;
}

SheetCurve sheet_curve(const MembraneTip& tip, const membrane::Law& law, double pretension,
                       const std::vector<double>& depth) {
  constexpr int parts = 5;  // between the depths asked for, so that the solver keeps to its path
  std::vector<double> levels;
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const double before = i == 0 ? 0 : depth[i - 1];
    for (int k = 1; k <= parts; ++k) levels.push_back(std::lerp(before, depth[i], static_cast<double>(k) / parts));
  }
  SheetCurve curve;
  const membrane::Problem problem = problem_of(tip, law, pretension, levels);
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

}  // namespace validate
