// A load on the path: what it adds to the energy at a level, how it is held there, and the depth conjugate to
// its force.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "atomistic/lattice/sheet.hpp"
#include "atomistic/problem.hpp"
#include "atomistic/team.hpp"

namespace atomistic {

/// Stiffness that a load gives to single atoms, for the preconditioner: eV/Å², 3×3, positive semi-definite.
struct AtomStiffness {
  int atom;
  Eigen::Matrix3d stiffness;
};

/// Positions x are those of the free atoms, 3·free_atoms. Everything belongs to the level set last.
class LoadTerm {
 public:
  virtual ~LoadTerm() = default;

  virtual void set_level(double level) = 0;

  /// Adds the load's gradient and returns its energy (eV), both at the level.
  virtual double add(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) = 0;

  /// c where the level holds c·x fixed; empty where it does not.
  virtual Eigen::VectorXd constraint() const { return {}; }

  /// The work-conjugate depth and force; `multiplier` is the constraint's.
  virtual double conjugate_depth(const Eigen::VectorXd& x) = 0;
  virtual double force(const Eigen::VectorXd& x, double multiplier) = 0;

  /// Work of dead forces and pressures, which is not stored in the sheet or the contact; part of add().
  virtual double dead_work(const Eigen::VectorXd&) { return 0; }

  /// A parameter that grows like the depth.
  virtual double parameter(double level) const = 0;

  /// Displacements to start the first level from: those of a clamped Föppl–von Kármán membrane without
  /// pretension; in-plane zero.
  virtual Eigen::VectorXd first_guess() const = 0;

  /// Moves a predicted state to where the load can hold it.
  virtual void admit(Eigen::VectorXd&) {}

  /// What the preconditioner should know, at a state.
  virtual std::vector<AtomStiffness> stiffness(const Eigen::VectorXd&) { return {}; }

  /// A direction k whose stiffness the load gives back, P → P − k kᵀ (a tip that is free to follow); empty:
  /// none.
  virtual Eigen::VectorXd given_back(const Eigen::VectorXd&) { return {}; }
};

/// The load of a problem on its sheet, both of which must outlive it. Throws std::invalid_argument for a load
/// that the sheet cannot take. With a team the sheet is this rank's part, positions are those of its own atoms, and
/// every rank asks for the same in the same order; for a pressure there is no team.
std::unique_ptr<LoadTerm> make_load(const Problem& problem, const Sheet& sheet, const Team& team = alone);

/// The atoms that carry a load in the flat sheet: all free ones for a pressure, those below the tip for a
/// sphere.
std::vector<int> loaded_atoms(const Load& load, const Sheet& sheet);

/// Schwerin's shape of a membrane under a central force, −depth (1 − (r/R)^{2/3}), its cusp rounded off by a
/// parabola within core_radius_A; in-plane zero.
Eigen::VectorXd schwerin_shape(const Sheet& sheet, double depth_A, double core_radius_A = 0);

/// The force that a central depth needs, roughly: F = E·h δ³/R² + 16πκ δ/R² (Eq. 16 with q = 1, and a clamped
/// plate).
double rough_force(const Problem& problem, double depth_A);

/// Its inverse.
double rough_depth(const Problem& problem, double force_eV_per_A);

}  // namespace atomistic
