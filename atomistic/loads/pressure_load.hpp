// Pressure on the free sheet: following the deformed surface, or dead.
#pragma once

#include <vector>

#include "atomistic/loads/load_term.hpp"

namespace atomistic {

/// The surface is a fan of triangles on each ring of atoms, from its centroid; V is the volume between it and z = 0,
/// downwards. In the flat perfect sheet every atom gets p times the area per atom.
class PressureTerm : public LoadTerm {
 public:
  /// Throws std::invalid_argument for a controlled depth: levels are pressures.
  PressureTerm(const PressureLoad& load, const Problem& problem, const Sheet& sheet);

  /// Area of the rings with a free atom, Å².
  double flat_area_A2() const { return area_; }

  /// Volume (Å³) and its gradient with respect to the free atoms.
  double volume(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) const;

  void set_level(double pressure) override { pressure_ = pressure; }
  double add(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) override;
  double conjugate_depth(const Eigen::VectorXd& x) override;  ///< volume over flat area
  double force(const Eigen::VectorXd&, double) override { return pressure_ * area_; }
  double dead_work(const Eigen::VectorXd& x) override { return -pressure_ * area_ * conjugate_depth(x); }
  double parameter(double pressure) const override;
  Eigen::VectorXd first_guess() const override;

 private:
  const Problem& problem_;
  const Sheet& sheet_;
  bool following_;
  std::vector<std::vector<int>> rings_;
  Eigen::VectorXd flat_share_;  ///< ∂V/∂x of the flat sheet
  double area_ = 0, pressure_ = 0;
};

}  // namespace atomistic
