#include "membrane/meridian/setup.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "membrane/base/refusal.hpp"
#include "membrane/laws/prestress.hpp"
#include "membrane/meridian/mesh.hpp"

namespace membrane::axisymmetric {
namespace {

std::vector<EnergyTerm> terms_of(const SheetProblem& problem) {
  const double tension = problem.pretension_eV_per_A2;
  const Voigt offset =
      std::visit([&](const auto& law) { return offset_strain(law, Voigt(tension, tension, 0)); }, problem.law);
  if (!offset.allFinite()) refuse("pretension_eV_per_A2", tension, "the law cannot carry it");
  Stretching stretching{problem.law, offset[0], problem.relaxed, 0};
  stretching.flat_energy = stretching.response(Voigt::Zero()).energy_eV_per_A2;
  return {stretching, Bending{problem.bending_modulus_eV}, Pressure{problem.pressure_eV_per_A3}};
}

std::vector<int> held_dofs(const SheetProblem& problem, int nodes) {
  const bool bends = problem.bending_modulus_eV > 0;
  const int rim = dofs_per_node * (nodes - 1);
  std::vector<int> held{0, rim + 2};  // u at the centre, w at the rim
  const bool cone = !bends && std::holds_alternative<PointLoad>(problem.load);
  if (!cone) held.push_back(3);                          // slope at the centre
  if (problem.rim == Rim::clamped) held.push_back(rim);  // u at the rim
  if (problem.rim == Rim::clamped && bends) held.push_back(rim + 3);
  return held;
}

struct PatternOf {
  const Assembly& assembly;
  Eigen::VectorXd operator()(const PointLoad&) const { return Eigen::VectorXd::Unit(assembly.dof_count(), 2); }
  Eigen::VectorXd operator()(const DiscLoad& disc) const {
    return assembly.pattern([](double) { return 1.0; }, disc.radius_A);
  }
  Eigen::VectorXd operator()(const ProfileLoad& profile) const {
    return assembly.pattern(profile.density, profile.radius_A);
  }
  Eigen::VectorXd operator()(const SphereLoad&) const { return {}; }
  Eigen::VectorXd operator()(const PressureLoad&) const { return {}; }
};

struct LoadRadius {
  double operator()(const PointLoad&) const { return 0; }
  double operator()(const PressureLoad&) const { return 0; }
  template <class Wide>
  double operator()(const Wide& load) const {
    return load.radius_A;
  }
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

double sheet_modulus(const SheetProblem& problem) {
  return std::visit([](const auto& law) -> double { return law.sheet_modulus_eV_per_A2; }, problem.law);
}

Assembly assembly_of(const SheetProblem& problem) {
  std::vector<double> nodes = nodes_for(problem);
  std::vector<int> held = held_dofs(problem, static_cast<int>(nodes.size()));
  std::optional<SphereContact> contact;
  if (const auto* sphere = std::get_if<SphereLoad>(&problem.load))
    contact = SphereContact{.radius_A = sphere->radius_A};
  return {std::move(nodes), std::move(held), terms_of(problem), contact};
}

Eigen::VectorXd pattern_of(const SheetProblem& problem, const Assembly& assembly) {
  return std::visit(PatternOf{assembly}, problem.load);
}

double conjugate_depth(const Eigen::VectorXd& pattern, const Eigen::VectorXd& x) {
  return pattern.size() > 0 ? pattern.dot(x) : x[2];
}

Eigen::VectorXd tip_shape(const SheetProblem& problem, const Assembly& assembly, const Eigen::VectorXd& pattern) {
  // A point's slope would be infinite: it is rounded over the first element.
  const double c = std::max(std::visit(LoadRadius{}, problem.load), assembly.nodes()[1]);
  const double rim = std::hypot(problem.radius_A, c);
  const Eigen::VectorXd x = shape(
      assembly, [&](double r) { return 1 - std::pow(std::hypot(r, c) / rim, 2.0 / 3); },
      [&](double r) { return -2.0 / 3 * r * std::pow(std::hypot(r, c), -4.0 / 3) * std::pow(rim, -2.0 / 3); });
  return x / conjugate_depth(pattern, x);
}

Eigen::VectorXd bulge_shape(const SheetProblem& problem, const Assembly& assembly, double pressure) {
  const double a = problem.radius_A;
  const double depth = 0.65 * a * std::cbrt(pressure * a / sheet_modulus(problem));
  return shape(
      assembly, [&](double r) { return depth * (1 - r * r / (a * a)); },
      [&](double r) { return -2 * depth * r / (a * a); });
}

double start_depth(const SheetProblem& problem, double force) {
  const double pi = std::numbers::pi;
  const double a = problem.radius_A;
  const double none = std::numeric_limits<double>::infinity();
  const double tension = problem.pretension_eV_per_A2;
  const double bending = problem.bending_modulus_eV;
  return std::min({std::cbrt(force * a * a / sheet_modulus(problem)), tension > 0 ? force / (pi * tension) : none,
                   bending > 0 ? force * a * a / (16 * pi * bending) : none});
}

}  // namespace membrane::axisymmetric
