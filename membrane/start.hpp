// The first guess of a path: a flat sheet without pretension has no stiffness out of its plane.
#pragma once

#include <Eigen/Core>

#include "membrane/mesh.hpp"

namespace membrane {

/// Schwerin's shape w ~ 1 − (ρ/ρ_a)^(2/3), exact under a point load for nu = 1/3, rounded over the load's
/// radius (ρ² = r² + c²) and scaled to the conjugate depth. In-plane displacements are zero, as they are
/// there. E. Schwerin, Z. angew. Math. Mech. 9 (1929) 482. Returns displacements over all degrees of freedom,
/// Å.
Eigen::VectorXd start_shape(const Mesh& mesh, const Eigen::VectorXd& pattern_weights, double sheet_radius_A,
                            double load_radius_A, double conjugate_depth_A);

/// Depth (Å) at which F = π N0 δ + E·h δ³/a²: of the right size for any load, which is all a start needs.
double start_depth(double force_eV_per_A, double sheet_modulus_eV_per_A2, double pretension_eV_per_A2,
                   double sheet_radius_A);

}  // namespace membrane
