// Point and disc: equal dead forces along −z on a set of free atoms, or their mean depth held.
#pragma once

#include <vector>

#include "atomistic/loads/load_term.hpp"

namespace atomistic {

class PatternLoad : public LoadTerm {
 public:
  /// Throws std::invalid_argument if there is no atom or, of a whole sheet, one of them is clamped; of a part the own
  /// ones alone are loaded.
  PatternLoad(std::vector<int> atoms, const Problem& problem, const Sheet& sheet, const Team& team = alone);

  /// c with c·x = mean z of the loaded atoms.
  const Eigen::VectorXd& direction() const { return direction_; }

  void set_level(double level) override { level_ = level; }
  double add(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) override;
  Eigen::VectorXd constraint() const override;
  double conjugate_depth(const Eigen::VectorXd& x) override { return -mean_z(x); }
  double force(const Eigen::VectorXd&, double multiplier) override { return dead() ? level_ : -multiplier; }
  double dead_work(const Eigen::VectorXd& x) override { return dead() ? level_ * mean_z(x) : 0.0; }
  double parameter(double level) const override;
  Eigen::VectorXd first_guess() const override;

 private:
  double mean_z(const Eigen::VectorXd& x) const { return team_.sum(direction_.dot(x)); }
  bool dead() const { return problem_.control == Control::force; }

  const Problem& problem_;
  const Sheet& sheet_;
  const Team& team_;
  Eigen::VectorXd direction_;
  double radius_A_ = 0;  ///< of the farthest loaded atom
  double level_ = 0;
};

}  // namespace atomistic
