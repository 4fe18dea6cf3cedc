#include "atomistic/lammps/atoms_here.hpp"

#include <mpi.h>
#define LAMMPS_LIB_MPI
#include <library.h>

#include <algorithm>

namespace atomistic {

using Eigen::Vector3d;
using Eigen::VectorXd;

AtomsHere::AtomsHere(void* lammps, int rank)
    : rank_(rank),
      count_(*static_cast<int*>(lammps_extract_global(lammps, "nlocal"))),
      id_(static_cast<int*>(lammps_extract_atom(lammps, "id"))),
      x_(static_cast<double**>(lammps_extract_atom(lammps, "x"))),
      v_(static_cast<double**>(lammps_extract_atom(lammps, "v"))),
      f_(static_cast<double**>(lammps_extract_atom(lammps, "f"))) {}

std::vector<int> AtomsHere::numbers() const {
  std::vector<int> atoms(id_, id_ + count_);
  for (int& atom : atoms) --atom;
  return atoms;
}

VectorXd AtomsHere::forces() const {
  VectorXd all(3 * static_cast<Eigen::Index>(count_));
  for (int i = 0; i < count_; ++i) all.segment<3>(3 * static_cast<Eigen::Index>(i)) = Eigen::Map<Vector3d>{f_[i]};
  return all;
}

void AtomsHere::belong_to(const std::vector<int>& own) const {
  for (int i = 0; i < count_; ++i) {
    const auto at = std::lower_bound(own.begin(), own.end(), id_[i] - 1);
    const bool moving = at != own.end() && *at == id_[i] - 1;
    v_[i][0] = moving ? rank_ : -1;
    v_[i][1] = moving ? static_cast<double>(at - own.begin()) : 0;
  }
}

/// Atoms of other owners that are here.
Halo AtomsHere::strangers() const {
  std::vector<Place> places;
  for (int i = 0; i < count_; ++i)
    if (moves(i) && place(i).rank != rank_) places.push_back(place(i));
  return Halo(places);
}

void AtomsHere::put(const VectorXd& positions) const {
  const VectorXd others = strangers().fetch(positions);
  Eigen::Index next = 0;
  for (int i = 0; i < count_; ++i) {
    if (!moves(i)) continue;
    const auto [owner, index] = place(i);
    Eigen::Map<Vector3d>{x_[i]} =
        owner == rank_ ? positions.segment<3>(3 * static_cast<Eigen::Index>(index)) : others.segment<3>(3 * next++);
  }
}

void AtomsHere::collect(VectorXd& forces) const {
  const Halo halo = strangers();
  VectorXd others(3 * static_cast<Eigen::Index>(halo.needed()));
  Eigen::Index next = 0;
  for (int i = 0; i < count_; ++i) {
    if (!moves(i)) continue;
    const auto [owner, index] = place(i);
    const Vector3d force = Eigen::Map<Vector3d>{f_[i]};
    if (owner == rank_)
      forces.segment<3>(3 * static_cast<Eigen::Index>(index)) = force;
    else
      others.segment<3>(3 * next++) = force;
  }
  halo.give_back(others, forces);
}

}  // namespace atomistic
