// Newton's method with conjugate gradients inside, for sheets whose softest directions a network of springs does not
// know.
#pragma once

#include "atomistic/equilibrium/minimiser.hpp"

namespace atomistic {

/// Moves x to a minimum: a trust region in the metric of the preconditioner, Steihaug's conjugate gradients in it (SIAM
/// J. Numer. Anal. 20 (1983) 626), Hessians as differences of gradients, one evaluation each. Where L-BFGS takes
/// thousands of evaluations, because folds cost next to nothing to move, the conjugate gradients see the whole
/// curvature.
MinimiserReport minimise_by_newton(const Minimisation& problem, const MinimiserOptions& options, Eigen::VectorXd& x,
                                   const OnIteration& on_iteration = {});

}  // namespace atomistic
