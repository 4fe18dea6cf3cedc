// The direction in which an equilibrium is softest, and the way out of one that is none.
#pragma once

#include <Eigen/Core>

#include "membrane/terms/total_energy.hpp"
#include "membrane/triangles/factor.hpp"

namespace membrane {

/// A direction of unit length over all degrees of freedom, and the second derivative of the energy along it (eV/Å²):
/// where that is negative the equilibrium is a saddle. Not finite where there is no tangent.
struct Softest {
  double stiffness_eV_per_A2 = 0;
  Eigen::VectorXd shape;
};

/// The lowest eigenvector of the tangent at u among the directions across `held` (a controlled depth's; zero: none), by
/// inverse iteration with a shift that makes the tangent positive definite: to a few per cent of what parts it from the
/// next one, which is enough to tell its sign.
Softest softest(TotalEnergy& energy, Factor& factor, const Eigen::VectorXd& u, const Eigen::VectorXd& held);

/// Moves u along the direction, to the side and as far as doubling steps lower the energy: from `smallest_A`, the
/// largest displacement of the first. False, and u as it was, where no step lowers it.
bool step_off(TotalEnergy& energy, const Softest& direction, double smallest_A, Eigen::VectorXd& u);

}  // namespace membrane
