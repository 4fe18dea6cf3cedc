#include "atomistic/equilibrium/break_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace atomistic {
namespace {

/// Without the vectors, which are large.
Step numbers_of(const Step& step) {
  Step numbers;
  numbers.target = step.target;
  numbers.conjugate_depth_A = step.conjugate_depth_A;
  numbers.force_eV_per_A = step.force_eV_per_A;
  numbers.longest_bond_A = step.longest_bond_A;
  return numbers;
}

}  // namespace

bool is_jump(double borne_bond_A, double broken_bond_A) {
  constexpr double jump_A = 0.05;
  return broken_bond_A >= ruptured_bond_A || broken_bond_A - borne_bond_A > jump_A;
}

bool BreakSearch::lost(double level, double longest_bond_A) const {
  constexpr double long_step_A = 0.1;  // as far as a bond may grow from level to level without a look between them
  if (longest_bond_A >= ruptured_bond_A) return true;
  if (longest_bond_A < artefact_bond_A_ || borne_.size() < 2) return false;
  const Step &before = borne_.front(), &last = borne_.back();
  if (last.longest_bond_A >= artefact_bond_A_) return false;
  if (broken_level_) return is_jump(last.longest_bond_A, longest_bond_A);
  const double steps = (level - last.target) / (last.target - before.target);
  const double grown_A = steps * (last.longest_bond_A - before.longest_bond_A);
  return longest_bond_A - last.longest_bond_A > std::max(long_step_A, grown_A);
}

bool BreakSearch::broken(const Step& step) const {
  if (!lost(step.target, step.longest_bond_A)) return false;
  if (step.longest_bond_A >= ruptured_bond_A || broken_level_ || !step.converged) return true;
  const Step& last = borne_.back();
  return step.force_eV_per_A < last.force_eV_per_A + slope() * (step.conjugate_depth_A - last.conjugate_depth_A);
}

void BreakSearch::take(const Step& step) {
  if (step.broken) {
    broken_level_ = step.target;
    broken_bond_A_ = step.longest_bond_A;
    if (!step.search) over_ = refuted_ = false;
    return;
  }
  const bool was_in_switch = !borne_.empty() && borne_.back().longest_bond_A >= artefact_bond_A_;
  const bool in_switch = step.longest_bond_A >= artefact_bond_A_;
  refuted_ =
      refuted_ || (broken_level_ && ((in_switch && !was_in_switch) || !is_jump(step.longest_bond_A, broken_bond_A_)));
  over_ = over_ || refuted_ || !step.converged;
  if (!step.converged) return;
  borne_.push_back(numbers_of(step));
  if (borne_.size() > 2) borne_.erase(borne_.begin());
}

/// Of the force over the depth, in the last step that was borne.
double BreakSearch::slope() const {
  const Step &before = borne_.front(), &last = borne_.back();
  return (last.force_eV_per_A - before.force_eV_per_A) / (last.conjugate_depth_A - before.conjugate_depth_A);
}

/// What the force could still grow by up to the level that broke, relative: along the last step's slope.
double BreakSearch::force_gap() const {
  const Step& last = borne_.back();
  if (!by_depth_) return (*broken_level_ - last.target) / last.target;
  if (borne_.size() < 2) return std::numeric_limits<double>::infinity();
  return std::abs(slope() * (*broken_level_ - last.target) / last.force_eV_per_A);
}

std::optional<double> BreakSearch::next_level() const {
  constexpr double enough = 0.01;
  if (!broken_level_ || over_ || borne_.empty() || !(*broken_level_ > borne_.back().target)) return std::nullopt;
  if (force_gap() <= enough) return std::nullopt;
  return 0.5 * (borne_.back().target + *broken_level_);
}

}  // namespace atomistic
