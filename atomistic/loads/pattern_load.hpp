// Point and disc: equal dead forces along −z on a set of free atoms, or their mean depth held.
#pragma once

#include <vector>

#include "atomistic/loads/load_term.hpp"

namespace atomistic {

class PatternLoad : public LoadTerm {
 public:
  /// Throws std::invalid_argument if there is no atom or one of them is clamped.
  PatternLoad(const std::vector<int>& atoms, const Problem& problem, const Sheet& sheet);

  /// c with c·x = mean z of the loaded atoms.
  const Eigen::VectorXd& direction() const { return direction_; }

  void set_level(double level) override { level_ = level; }
  double add(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) override;
  Eigen::VectorXd constraint() const override;
  double conjugate_depth(const Eigen::VectorXd& x) override { return -direction_.dot(x); }
  double force(const Eigen::VectorXd&, double multiplier) override { return dead() ? level_ : -multiplier; }
  double dead_work(const Eigen::VectorXd& x) override { return dead() ? level_ * direction_.dot(x) : 0.0; }
  double parameter(double level) const override;
  Eigen::VectorXd first_guess() const override;

 private:
  bool dead() const { return problem_.control == Control::force; }

  const Problem& problem_;
  const Sheet& sheet_;
  Eigen::VectorXd direction_;
  double radius_A_ = 0;  ///< of the farthest loaded atom
  double level_ = 0;
};

}  // namespace atomistic
