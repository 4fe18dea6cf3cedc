#include "membrane/meridian/setup.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "membrane/base/refusal.hpp"
#include "membrane/laws/prestress.hpp"
#include "membrane/meridian/mesh.hpp"
#include "membrane/meridian/round_problem.hpp"

namespace membrane::meridian {
namespace {

std::vector<EnergyTerm> terms_of(const Problem& problem) {
  const double tension = pretension_eV_per_A2(problem);
  const Voigt offset = std::visit(
      [&]<MaterialLaw L>(const L& law) { return offset_strain(law, Voigt(tension, tension, 0)); }, problem.law);
  if (!offset.allFinite()) refuse("prestress_eV_per_A2", tension, "the law cannot carry this prestress");
  Stretching stretching{problem.law, offset[0], problem.relaxed, 0};
  stretching.flat_energy = stretching.response(Voigt::Zero()).energy_eV_per_A2;
  return {stretching, Bending{bending_modulus_eV(problem)}, Pressure{problem.pressure_eV_per_A3}};
}

std::vector<int> held_dofs(const Problem& problem, int nodes) {
  const bool bends = problem.bending.has_value();
  const bool clamped = std::get<DiscSheet>(problem.sheet).rim == Support::clamped;
  const int rim = dofs_per_node * (nodes - 1);
  std::vector<int> held{0, rim + 2};  // u at the centre, w at the rim
  const bool cone = !bends && traits_of(problem).peaked;
  if (!cone) held.push_back(3);      // slope at the centre
  if (clamped) held.push_back(rim);  // u at the rim
  if (clamped && bends && std::isinf(rim_spring_eV(problem))) held.push_back(rim + 3);
  return held;
}

struct PatternOf {
  const Assembly& assembly;
  Eigen::VectorXd operator()(const CentreForce&) const { return Eigen::VectorXd::Unit(assembly.dof_count(), 2); }
  Eigen::VectorXd operator()(const SpreadForce& load) const { return assembly.pattern(load.density, load.radius_A); }
  Eigen::VectorXd operator()(const RigidSphere&) const { return {}; }
  Eigen::VectorXd operator()(const FollowerPressure&) const { return {}; }
  Eigen::VectorXd operator()(const EdgeMotion&) const { return {}; }
};

template <class Depth, class Slope>
Eigen::VectorXd shape(const Assembly& assembly, Depth depth, Slope slope) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(assembly.dof_count());
  for (int n = 0; n <= assembly.element_count(); ++n) {
    x[dofs_per_node * n + 2] = depth(assembly.nodes()[n]);
    x[dofs_per_node * n + 3] = slope(assembly.nodes()[n]);
  }
  assembly.release_held(x);
  return x;
}

}  // namespace

Assembly assembly_of(const Problem& problem) {
  std::vector<double> nodes = nodes_for(problem);
  std::vector<int> held = held_dofs(problem, static_cast<int>(nodes.size()));
  std::optional<SphereContact> contact;
  if (const Traits load = traits_of(problem); load.sphere) contact = SphereContact{.radius_A = load.radius_A};
  const double spring = rim_spring_eV(problem);
  return {std::move(nodes),
          std::move(held),
          terms_of(problem),
          contact,
          std::isinf(spring) ? 0 : spring,
          problem.edge_tension_eV_per_A2 > 0 ? rim_pull_eV_per_A(problem) : 0,
          rim_stiffness_eV_per_A2(problem)};
}

Eigen::VectorXd pattern_of(const Problem& problem, const Assembly& assembly) {
  return std::visit(PatternOf{assembly}, action_of(problem.load));
}

double conjugate_depth(const Eigen::VectorXd& pattern, const Eigen::VectorXd& x) {
  return pattern.size() > 0 ? pattern.dot(x) : x[2];
}

Eigen::VectorXd tip_shape(const Problem& problem, const Assembly& assembly, const Eigen::VectorXd& pattern) {
  // A point's slope would be infinite: it is rounded over the first element.
  const double c = std::max(traits_of(problem).radius_A, assembly.nodes()[1]);
  const double rim = std::hypot(radius_A(problem), c);
  const Eigen::VectorXd x = shape(
      assembly, [&](double r) { return 1 - std::pow(std::hypot(r, c) / rim, 2.0 / 3); },
      [&](double r) { return -2.0 / 3 * r * std::pow(std::hypot(r, c), -4.0 / 3) * std::pow(rim, -2.0 / 3); });
  return x / conjugate_depth(pattern, x);
}

Eigen::VectorXd bulge_shape(const Problem& problem, const Assembly& assembly, double pressure) {
  const double a = radius_A(problem);
  const double depth = 0.65 * a * std::cbrt(pressure * a / sheet_modulus(problem.law));
  return shape(
      assembly, [&](double r) { return depth * (1 - r * r / (a * a)); },
      [&](double r) { return -2 * depth * r / (a * a); });
}

Eigen::VectorXd evenly_stretched(const Problem& problem, const Assembly& assembly) {
  const double strain = problem.edge_tension_eV_per_A2 * (1 - poisson_ratio(problem.law)) / sheet_modulus(problem.law);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(assembly.dof_count());
  for (int n = 0; n <= assembly.element_count(); ++n)
    x.segment<2>(dofs_per_node * n) << strain * assembly.nodes()[n], strain;
  assembly.release_held(x);
  return x;
}

double start_depth(const Problem& problem, double force) {
  const double pi = std::numbers::pi;
  const double a = radius_A(problem);
  const double none = std::numeric_limits<double>::infinity();
  const double tension = pretension_eV_per_A2(problem) + problem.edge_tension_eV_per_A2;
  const double bending = bending_modulus_eV(problem);
  return std::min({std::cbrt(force * a * a / sheet_modulus(problem.law)), tension > 0 ? force / (pi * tension) : none,
                   bending > 0 ? force * a * a / (16 * pi * bending) : none});
}

}  // namespace membrane::meridian
