// The atoms that LAMMPS has on this rank, and whose they are where the ranks share them.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "atomistic/ranks/halo.hpp"

namespace atomistic {

/// A look at LAMMPS's arrays, good until its next command. Who owns an atom, and as its which, is written into its
/// velocity, which nothing else uses here and which LAMMPS hands on with the atom; −1 for an atom that does not move.
class AtomsHere {
 public:
  AtomsHere(void* lammps, int rank);

  std::vector<int> numbers() const;  ///< of the atoms, counted from 0, in LAMMPS's order
  Eigen::VectorXd forces() const;    ///< in the same order

  /// Those in `own`, ascending, are this rank's from now on; the others do not move. While every atom is still where it
  /// was made.
  void belong_to(const std::vector<int>& own) const;

  /// Positions of the own atoms into LAMMPS's arrays, and their forces out of them, on whichever rank it has them. All
  /// ranks call it.
  void put(const Eigen::VectorXd& positions) const;
  void collect(Eigen::VectorXd& forces) const;

 private:
  bool moves(int i) const { return v_[i][0] >= 0; }
  Place place(int i) const { return {static_cast<int>(v_[i][0]), static_cast<int>(v_[i][1])}; }
  Halo strangers() const;

  int rank_, count_;
  const int* id_;
  double **x_, **v_, **f_;
};

}  // namespace atomistic
