#include "membrane/meridian/record.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <variant>

#include "membrane/meridian/round_problem.hpp"
#include "membrane/meridian/setup.hpp"

namespace membrane::meridian {
namespace {

MeridianPoint point_at(const Stretching& stretching, double radius, const Eigen::Vector4d& node) {
  LocalState y = LocalState::Zero();
  y << node[0], node[1], 0, node[2], node[3], 0;
  // On the axis both strains are the radial one's limit: u/s -> u'.
  const double s = radius > 0 ? radius : 1;
  if (radius == 0) y[U] = y[U1] * s;
  const Voigt strain = Stretching::strain(s, y);
  const Voigt force = stretching.response(strain).force_eV_per_A2;
  return {radius, node[0], node[2], strain[0], strain[1], force[0], force[1]};
}

/// Of the area that the quadrature's points stand for.
Tautness tautness_of(const Assembly& assembly, const Eigen::VectorXd& x, const Stretching& stretching) {
  Tautness found;
  found.least_force_eV_per_A2 = std::numeric_limits<double>::infinity();
  const double rounding = least_compression(stretching.law);
  const auto share_where = [&](auto holds) {
    return assembly.sum(x, [&](const Ring& ring, const LocalState& y) {
      return holds(Stretching::strain(ring.radius_A, y)) ? ring.area_A2 : 0.0;
    }) / assembly.sum(x, [](const Ring& ring, const LocalState&) { return ring.area_A2; });
  };
  const auto in_state = [&](SheetState state) {
    return share_where([&](const Voigt& strain) { return stretching.relaxed && stretching.state(strain) == state; });
  };
  found.wrinkled_area_fraction = in_state(SheetState::wrinkled);
  found.slack_area_fraction = in_state(SheetState::slack);
  found.compressed_area_fraction = share_where([&](const Voigt& strain) {
    const double least = stretching.response(strain).force_eV_per_A2.head<2>().minCoeff();
    found.least_force_eV_per_A2 = std::min(found.least_force_eV_per_A2, least);
    return least < -rounding;
  });
  return found;
}

}  // namespace

Step record(const Problem& problem, Assembly& assembly, const Eigen::VectorXd& x, double flat_energy_eV) {
  Step step;
  step.depth_A = assembly.state_at(problem.record_radius_A, x)[W];
  Eigen::VectorXd gradient;
  assembly.energy(x, gradient);
  step.rim_displacement_A = x[x.size() - dofs_per_node];
  step.energy_eV = assembly.parts()[stretching_term] + assembly.parts()[bending_term] - flat_energy_eV;
  if (problem.edge_tension_eV_per_A2 > 0) step.energy_eV += rim_potential_eV(problem, step.rim_displacement_A);
  step.bending_energy_eV = assembly.parts()[bending_term];
  step.pressure_eV_per_A3 = std::get<Pressure>(assembly.terms()[pressure_term]).pressure_eV_per_A3;
  // The pressure's potential counts the disc that the rim spans as if it moved with it: that part is no
  // reaction.
  const double rim = radius_A(problem) + step.rim_displacement_A;
  step.support_force_eV_per_A.z() =
      step.pressure_eV_per_A3 * std::numbers::pi * rim * rim - assembly.full_gradient()[x.size() - 2];
  step.volume_A3 =
      -assembly.sum(x, [](const Ring& ring, const LocalState& y) { return ring.area_A2 * Pressure{1}(ring, y).value; });
  const auto& stretching = std::get<Stretching>(assembly.terms()[stretching_term]);
  step.tautness = tautness_of(assembly, x, stretching);
  MeridianShape shape;
  for (int n = 0; n <= assembly.element_count(); ++n)
    shape.points.push_back(point_at(stretching, assembly.nodes()[n], x.segment<dofs_per_node>(dofs_per_node * n)));
  const MeridianPoint& edge = shape.points.back();
  step.rim_membrane_force_eV_per_A2 = std::max(edge.radial_force_eV_per_A2, edge.hoop_force_eV_per_A2);
  step.shape = std::move(shape);
  return step;
}

}  // namespace membrane::meridian
