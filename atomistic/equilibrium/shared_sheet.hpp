// A sheet that the ranks share: what each has of it, and how they hand numbers to each other.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "atomistic/equilibrium/network_solver.hpp"
#include "atomistic/lammps/lammps.hpp"
#include "atomistic/lattice/sheet_part.hpp"
#include "atomistic/problem.hpp"
#include "atomistic/ranks/halo.hpp"
#include "atomistic/ranks/mpi_team.hpp"

namespace atomistic {

/// Every rank owns the atoms that LAMMPS has on it when the sheet is flat. Vectors of free atoms are those of the own.
class SharedSheet {
 public:
  /// All ranks construct it. Shares the force field's atoms out. Throws std::runtime_error for more ranks than there is
  /// sheet for.
  SharedSheet(const Sheet& whole, ForceField& forces);

  const Sheet& part() const { return part_.sheet; }
  const Team& team() const { return team_; }

  /// Positions of the part's atoms: gives the ghosts those that their owners have.
  void refresh(Eigen::VectorXd& positions) const;

  std::unique_ptr<NetworkSolver> solver(const SpringConstants& constants) const;

  /// A step of this rank's part from one of the whole sheet.
  Step part_of_step(const Step& whole) const;

  /// The whole on rank 0, the part's own elsewhere. All ranks call it, right after the step's last evaluation.
  Step whole_step(const Step& part) const;

 private:
  std::vector<int> numbers() const;

  MpiTeam team_;
  const ForceField& forces_;
  Eigen::VectorXd flat_;  ///< the whole sheet on rank 0
  SheetPart part_;
  std::vector<int> own_;
  Halo halo_;
};

}  // namespace atomistic
