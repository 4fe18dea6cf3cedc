// LAMMPS as a function from positions to energy and forces. The only place that knows its library interface.
//
// Debian's LAMMPS is built without exceptions: an error inside it ends the process with its message in the
// log.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "atomistic/problem.hpp"

namespace atomistic {

/// The periodic cell, or the box that holds an isolated sheet.
struct Box {
  Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = Eigen::Vector3d::Zero();
  double tilt_xy = 0;
  bool periodic = false;  ///< in the plane; never along z
};

struct ForceTiming {
  long calls = 0;
  double force_s = 0;  ///< pair, neighbour, communication
  double setup_s = 0;  ///< creating the atoms, and the set-up runs with their first force computation
};

/// A potential's description asks for something that this LAMMPS does not have.
struct BadPotential : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// MPI, for the process's life. Holds what the ranks other than 0 need: they serve force computations only.
class MpiSession {
 public:
  MpiSession(int* argc, char*** argv);
  ~MpiSession();
  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;
  int rank() const;
  int ranks() const;
  [[noreturn]] static void abort(int code);  ///< ends every rank
};

/// LAMMPS's release date as a number, 20210929. All ranks call it.
int lammps_release();

/// Langevin dynamics of the first atoms, the others held, at constant forces on some of them. A step of 1 fs shifts the
/// averages of the stiffest vibrations by 2 %, those of the others by less than 0.1 %.
struct LangevinBath {
  double temperature_K = 0;
  double damping_ps = 0.8;  ///< weak: a vibration's mean is known the sooner the less it is damped
  double step_ps = 1e-3;
  int free_atoms = 0;
  std::vector<int> loaded;    ///< share the force
  double force_eV_per_A = 0;  ///< along −z
};

/// Where a dynamics is: 3N numbers each, Å and Å/ps.
struct PhasePoint {
  Eigen::VectorXd positions, velocities;
};

/// One LAMMPS instance with a fixed set of carbon atoms. All ranks construct that of a sheet; rank 0 then calls
/// evaluate(), the others serve() until rank 0's object is destroyed. A periodic cell is small: a rank that
/// constructs one has it to itself. Positions and forces are 3N vectors in creation order, valid on rank 0.
class ForceField {
 public:
  ForceField(const Potential& potential, const Box& box, const Eigen::VectorXd& positions, const std::string& log_file);
  ~ForceField();
  ForceField(const ForceField&) = delete;
  ForceField& operator=(const ForceField&) = delete;

  /// Potential energy (eV); forces in eV/Å. `fresh` rebuilds the neighbour list first, so that the result
  /// depends on the positions alone.
  double evaluate(const Eigen::VectorXd& positions, Eigen::VectorXd& forces, bool fresh = false);

  /// Changes a periodic cell; the next evaluation is fresh.
  void set_box(const Box& box);

  /// In-plane virial stress times the box height, N_ij (eV/Å²; tension positive), of the last evaluation.
  Eigen::Matrix2d membrane_force() const;

  /// Each atom's share of the virial (eV, tension positive) at these positions: xx, yy, zz, xy, xz, yz, atom by atom.
  /// Their sum is the stress times the volume; how it is shared out among the atoms of a bond or an angle is LAMMPS's
  /// convention (`compute stress/atom`), which an average over some ten atoms no longer shows.
  Eigen::VectorXd virials(const Eigen::VectorXd& positions);

  /// The atoms, counted from 0, that LAMMPS has on this rank now: ascending.
  std::vector<int> atoms_here() const;

  /// Shares the atoms out: from here on `own` are this rank's (those that move, ascending), and every rank calls
  /// evaluate_own() instead of rank 0 evaluate() and the others serve(). Where LAMMPS has meanwhile passed an atom on
  /// to another rank, its position and force travel between the two.
  void share_out(const std::vector<int>& own);
  double evaluate_own(const Eigen::VectorXd& positions, Eigen::VectorXd& forces, bool fresh);

  /// The forces of the last evaluation, of all atoms, on rank 0.
  Eigen::VectorXd gather_forces() const;

  /// Goes on from a phase point and leaves where it has come to; without velocities it draws them. The depth of the
  /// loaded atoms, mean −z, after every `every` steps. What is drawn depends on the seed alone, and a stretch on its
  /// beginning and its seed. One rank only.
  std::vector<double> langevin(const LangevinBath& bath, PhasePoint& at, int steps, int every, unsigned seed);

  /// Answers rank 0's evaluations; returns when rank 0 has destroyed its object.
  void serve();

  const ForceTiming& timing() const;

 private:
  struct Instance;
  std::unique_ptr<Instance> instance_;
};

}  // namespace atomistic
