// Where a sheet of triangles is wrinkled, or bears compression.
#pragma once

#include "membrane/problem.hpp"
#include "membrane/terms/stretching.hpp"

namespace membrane {

/// Of the meshed part at displacements u: a sheet that is not relaxed has compression where it is more than rounding.
Tautness tautness_of(const Mesh& mesh, const Material& material, const Eigen::VectorXd& u);

/// Mean outward displacement of a round sheet's rim, Å; 0 where there is none.
double mean_outward_on_rim(const Mesh& mesh, const Eigen::VectorXd& u);

}  // namespace membrane
