#include "atomistic/loads/pattern_load.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace atomistic {

using Eigen::VectorXd;

PatternLoad::PatternLoad(std::vector<int> atoms, const Problem& problem, const Sheet& sheet, const Team& team)
    : problem_(problem), sheet_(sheet), team_(team) {
  if (&team != &alone) std::erase_if(atoms, [&](int atom) { return atom >= sheet.free_atoms; });
  const double count = team.sum(static_cast<double>(atoms.size()));
  if (count == 0 || std::ranges::any_of(atoms, [&](int atom) { return atom >= sheet.free_atoms; }))
    throw std::invalid_argument("load: it must hold at least one atom and none of the clamped ones");
  direction_.setZero(3 * sheet.free_atoms);
  for (int atom : atoms) {
    direction_[3 * atom + 2] = 1.0 / count;
    radius_A_ = std::max(radius_A_, sheet.position(atom).norm());
  }
  radius_A_ = team.largest(radius_A_);
}

double PatternLoad::add(const VectorXd& x, VectorXd& gradient) {
  if (!dead()) return 0;
  gradient += level_ * direction_;
  return dead_work(x);
}

VectorXd PatternLoad::constraint() const { return dead() ? VectorXd() : direction_; }

double PatternLoad::parameter(double level) const { return dead() ? std::cbrt(level) : level; }

VectorXd PatternLoad::first_guess() const {
  return schwerin_shape(sheet_, dead() ? rough_depth(problem_, level_) : level_, radius_A_);
}

}  // namespace atomistic
