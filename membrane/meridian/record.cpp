#include "membrane/meridian/record.hpp"

#include <algorithm>
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

}  // namespace

Step record(const Problem& problem, Assembly& assembly, const Eigen::VectorXd& x) {
  Step step;
  step.depth_A = assembly.state_at(problem.record_radius_A, x)[W];
  Eigen::VectorXd gradient;
  assembly.energy(x, gradient);
  step.energy_eV = assembly.parts()[stretching_term] + assembly.parts()[bending_term];
  step.bending_energy_eV = assembly.parts()[bending_term];
  step.pressure_eV_per_A3 = std::get<Pressure>(assembly.terms()[pressure_term]).pressure_eV_per_A3;
  // The pressure's potential counts the disc that the rim spans as if it moved with it: that part is no
  // reaction.
  const double rim = radius_A(problem) + x[x.size() - 4];
  step.support_force_eV_per_A.z() =
      step.pressure_eV_per_A3 * std::numbers::pi * rim * rim - assembly.full_gradient()[x.size() - 2];
  step.volume_A3 =
      -assembly.sum(x, [](const Ring& ring, const LocalState& y) { return ring.area_A2 * Pressure{1}(ring, y).value; });
  const auto& stretching = std::get<Stretching>(assembly.terms()[stretching_term]);
  MeridianShape shape;
  for (int n = 0; n <= assembly.element_count(); ++n)
    shape.points.push_back(point_at(stretching, assembly.nodes()[n], x.segment<dofs_per_node>(dofs_per_node * n)));
  const MeridianPoint& edge = shape.points.back();
  step.rim_membrane_force_eV_per_A2 = std::max(edge.radial_force_eV_per_A2, edge.hoop_force_eV_per_A2);
  step.shape = std::move(shape);
  return step;
}

}  // namespace membrane::meridian
