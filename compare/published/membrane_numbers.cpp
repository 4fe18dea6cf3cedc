#include <cmath>
#include <numbers>
#include <stdexcept>

#include "compare/base/errors.hpp"
#include "compare/published/numbers.hpp"
#include "membrane/problem.hpp"

namespace validate::published {
namespace {

using std::numbers::pi;

constexpr double a = 1000, Eh = 20;  // what is asked for does not depend on them

membrane::Problem disc(double nu) {
  membrane::Problem problem;
  problem.sheet = membrane::DiscSheet{.radius_A = a};
  problem.law = membrane::StVenantKirchhoff{Eh, nu};
  problem.discretisation = membrane::Meridian{};
  return problem;
}

membrane::Step last_step(const membrane::Problem& problem) {
  membrane::Step last;
  const membrane::Report report = membrane::solve(problem, [&](const membrane::Step& step) {
    last = step;
    return step.converged;
  });
  if (!report.converged) throw Error(ExitCode::not_converged, "the membrane of a published number: " + report.reason);
  return last;
}

/// A point is a disc of 1e-7 a: the force is then high by some (c/a)^(2/3), 4e-5.
membrane::Step point_load(double nu, double depth, double pretension) {
  membrane::Problem problem = disc(nu);
  problem.load = membrane::DiscLoad{1e-7 * a};
  problem.prestress_eV_per_A2 = pretension * Eigen::Matrix2d::Identity();
  problem.levels = {depth};
  return last_step(problem);
}

constexpr double shallow = 0.005 * a;  // finite strain adds 1e-4

double alpha(double nu) {
  const membrane::Step step = point_load(nu, shallow, 0);
  return step.force_eV_per_A * a * a / (Eh * std::pow(step.depth_A, 3));
}

/// By a centred difference that is small beside the tension that the depth makes.
double beta(double nu) {
  const double small = 1e-3 * Eh * std::pow(shallow / a, 2);
  return (point_load(nu, shallow, small).force_eV_per_A - point_load(nu, shallow, -small).force_eV_per_A) /
         (2 * small * pi * shallow);
}

/// So shallow that stretching adds nothing.
double taut_disc(double nu, double tip_ratio) {
  constexpr double N0 = 0.1;
  membrane::Problem problem = disc(nu);
  problem.load = membrane::DiscLoad{tip_ratio * a};
  problem.prestress_eV_per_A2 = N0 * Eigen::Matrix2d::Identity();
  problem.levels = {5e-5 * a};
  const membrane::Step step = last_step(problem);
  return step.force_eV_per_A / (N0 * step.depth_A);
}

double hencky(double nu) {
  constexpr double load = 1e-6;  // p a/(E·h): finite strain adds 1e-4
  membrane::Problem problem = disc(nu);
  problem.load = membrane::PressureLoad{};
  problem.control = membrane::Control::force;
  problem.levels = {load * Eh / a};
  return last_step(problem).depth_A / a / std::cbrt(load);
}

}  // namespace

double number_of_membrane(const Entry& entry) {
  const double nu = entry.nu.value();
  switch (entry.quantity) {
    case Subject::point_alpha:
      return alpha(nu);
    case Subject::point_beta:
      return beta(nu);
    case Subject::taut_disc:
      return taut_disc(nu, entry.tip_ratio.value());
    case Subject::hencky:
      return hencky(nu);
    default:
      throw std::logic_error("not the membrane's number");
  }
}

}  // namespace validate::published
