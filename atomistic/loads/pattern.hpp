// A load is a pattern: non-negative weights with unit total on free atoms, acting along −z, and the depth
// that is conjugate to its force.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "atomistic/problem.hpp"
#include "atomistic/sheet.hpp"

namespace atomistic {

/// The atoms that share a load's force, in the flat sheet.
std::vector<int> loaded_atoms(const Load& load, const Sheet& sheet);

class LoadPattern {
 public:
  /// Throws std::invalid_argument if the load holds no free atom or reaches the clamp.
  LoadPattern(const Load& load, const Sheet& sheet);

  /// c with c·x = mean z of the loaded atoms; 3·free_atoms.
  const Eigen::VectorXd& direction() const { return direction_; }
  double conjugate_depth(const Eigen::VectorXd& free_positions) const {
    return -direction_.dot(free_positions);
  }
  const std::vector<int>& atoms() const { return atoms_; }

 private:
  std::vector<int> atoms_;
  Eigen::VectorXd direction_;
};

}  // namespace atomistic
