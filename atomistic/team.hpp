// The ranks that share one sheet, as those who compute on their part of it see them.
#pragma once

namespace atomistic {

/// What all ranks say together; here of one rank that has everything. Every rank asks in the same order.
class Team {
 public:
  virtual ~Team() = default;
  virtual double sum(double own) const { return own; }      ///< over the ranks, the same on all of them
  virtual double largest(double own) const { return own; }  ///< of the ranks'
  double least(double own) const { return -largest(-own); }
};

/// A rank that shares its sheet with nobody.
inline const Team alone;

}  // namespace atomistic
