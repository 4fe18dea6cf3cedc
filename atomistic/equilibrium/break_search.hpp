// Where a sheet breaks: whether a state has come apart, and the levels between the last that it bore and the first that
// it did not.
#pragma once

#include <optional>
#include <vector>

#include "atomistic/problem.hpp"

namespace atomistic {

/// Beyond this length no bundled carbon potential binds any more: AIREBO and REBO end at 2.0 Å.
inline constexpr double ruptured_bond_A = 2.0;

/// Takes the states of a path in their order and halves the last step until the breaking force is known well enough.
class BreakSearch {
 public:
  /// `artefact_bond_A`: the potential's. `by_depth`: the levels are depths, else they are loads.
  BreakSearch(double artefact_bond_A, bool by_depth) : artefact_bond_A_(artefact_bond_A), by_depth_(by_depth) {}

  /// Whether a sheet with this longest bond has lost its balance at a level: a bond is beyond the reach of the
  /// potential, or in the switch by a jump. One that grows into the switch step by step has not broken; one that was
  /// far from it a step before, and grew slowly, is one that the switch has caught.
  bool lost(double level, double longest_bond_A) const;

  /// Whether a minimisation's end has come apart: lost as above, and the load has fallen behind its own slope or the
  /// atoms have come to no rest. In the switch alone they would have stiffened.
  bool broken(const Step& step) const;

  /// A state on the way there, with Step::broken as found. The search is over at one that is neither borne nor broken.
  void take(const Step& step);

  /// The level to try next; nothing where no state broke, none was borne before, or the force is known to 1 %.
  std::optional<double> next_level() const;

  /// Whether the search has found that what looked like a jump was a long step: the bond grows into the switch.
  bool refuted() const { return refuted_; }

 private:
  double force_gap() const;
  double slope() const;

  double artefact_bond_A_;
  bool by_depth_;
  std::vector<Step> borne_;  ///< the last two, without their vectors
  std::optional<double> broken_level_;
  double broken_bond_A_ = 0;  ///< at that level
  bool over_ = false, refuted_ = false;
};

/// Whether two bonds, of the last state borne and of the first broken, are those of a break.
bool is_jump(double borne_bond_A, double broken_bond_A);

}  // namespace atomistic
