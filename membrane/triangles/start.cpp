#include "membrane/triangles/start.hpp"

#include <algorithm>
#include <cmath>

#include "membrane/triangles/tuning.hpp"

namespace membrane {
namespace {

/// Distance of the farthest node from the origin, Å: the scale of small displacements.
double size_of(const Mesh& mesh) {
  double size = 0;
  for (const Eigen::Vector2d& X : mesh.nodes) size = std::max(size, X.norm());
  return size;
}

}  // namespace

template <class Call>
Eigen::VectorXd StiffenedSheet::while_stiffened(Call call) {
  const Material material = model_.stretching().material();
  const double modulus = sheet_modulus(material.law);
  const double nu = poisson_ratio(material.law);
  const double strain = StartTuning::stiffening * (1 - std::min(nu, 0.5));
  model_.stretching().set_material({StVenantKirchhoff{modulus, std::min(nu, 0.5)}, Voigt(strain, strain, 0), false});
  Eigen::VectorXd answer = call();
  model_.stretching().set_material(material);
  return answer;
}

Eigen::VectorXd StiffenedSheet::under_forces(const Eigen::VectorXd& forces) {
  return while_stiffened([&] {
    Eigen::VectorXd free = forces;
    model_.energy().release_held(free);
    return newton_.linear_response(Eigen::VectorXd::Zero(forces.size()), free);
  });
}

/// The forces that a held displacement causes inside come from a difference of gradients.
Eigen::VectorXd StiffenedSheet::under_motion(const Eigen::VectorXd& held_displacements) {
  return while_stiffened([&] {
    const double small = StartTuning::small_motion * size_of(model_.mesh()) / held_displacements.cwiseAbs().maxCoeff();
    Eigen::VectorXd at_rest, moved;
    model_.energy().energy(Eigen::VectorXd::Zero(held_displacements.size()), at_rest);
    model_.energy().energy(small * held_displacements, moved);
    Eigen::VectorXd forces = (at_rest - moved) / small;
    model_.energy().release_held(forces);
    return Eigen::VectorXd(held_displacements + newton_.linear_response(Eigen::VectorXd::Zero(forces.size()), forces));
  });
}

Eigen::VectorXd evenly_stretched(Model& model, double tension_eV_per_A2) {
  const Law& law = model.stretching().material().law;
  const double strain = tension_eV_per_A2 * (1 - poisson_ratio(law)) / sheet_modulus(law);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(model.energy().dof_count());
  for (int n = 0; n < model.mesh().node_count(); ++n) u.segment<2>(3 * n) = strain * model.mesh().nodes[n];
  return u;
}

/// The slope of Π along the shape is negative at 0 and rises once stretching outweighs the load: bracket, then bisect.
double balanced_amplitude(Model& model, const Eigen::VectorXd& shape, const Eigen::VectorXd& forces) {
  Eigen::VectorXd gradient;
  const double work = forces.dot(shape);
  const auto slope = [&](double amplitude) {
    model.energy().energy(amplitude * shape, gradient);
    return gradient.dot(shape) - work;
  };
  double low = 0, high = 1e-3 * size_of(model.mesh()) / shape.cwiseAbs().maxCoeff();
  while (slope(high) < 0 && std::isfinite(high)) {
    low = high;
    high *= 2;
  }
  for (int i = 0; i < StartTuning::bisections; ++i) {
    const double middle = 0.5 * (low + high);
    (slope(middle) < 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace membrane
