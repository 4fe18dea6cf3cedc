// One E·h for many curves: pretension, contact, zeros and noise of each its own, errors of the calibration shared.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "compare/fitting/likelihood.hpp"
#include "compare/results/many.hpp"

namespace validate {

/// One curve of the joint fit.
struct JointCurve {
  Likelihood likelihood;
  Eigen::VectorXd start;  ///< near its own maximum
  int drum = 0;           ///< curves of one drum share its radius too
};

/// Maximum of the sum of all curves' likelihoods, each input's z counted once: the radius once a drum, all others once.
/// For given shared parameters every curve is maximised over its own; the shared ones follow by Newton's method with
/// the curves' Schur complements. `for_all(n, work)` calls work(i) for i < n in any order, on as many threads as it
/// likes. `numerical` is the relative error of the forces. An empty reason means that it converged.
struct JointOutcome {
  JointFit fit;
  std::string reason;
};
using ForAll = std::function<void(std::size_t, const std::function<void(std::size_t)>&)>;
JointOutcome joint_fit(std::vector<JointCurve> curves, double numerical, const ForAll& for_all);

}  // namespace validate
