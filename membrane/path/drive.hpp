// How the levels of a path act on a sheet: guesses, targets, and what lies between two levels.
#pragma once

#include <memory>

#include "membrane/triangles/model.hpp"
#include "membrane/triangles/newton.hpp"

namespace membrane {

/// One kind of load on its way. Values are the levels of a problem, in their own unit.
class Drive {
 public:
  virtual ~Drive() = default;

  /// Displacements to begin with, held ones and a controlled depth as the value wants them; sets what acts through an
  /// energy.
  virtual Eigen::VectorXd guess(double value) = 0;
  /// What Newton's method keeps to.
  virtual Target target(double value) = 0;
  /// An equilibrium was reached.
  virtual void passed(double value, const Equilibrium& at, const Eigen::VectorXd& u) = 0;
  /// A value between the present one and one that could not be reached.
  virtual double between(double value) const = 0;
  virtual const char* unit() const = 0;
  /// What the load's work is counted by (Step::conjugate_depth_A).
  virtual double conjugate_depth(const Eigen::VectorXd& u) const = 0;
  /// The edge that is moved, if one is.
  virtual const EdgeMotion* motion() const { return nullptr; }
};

/// The load of a problem, from the flat sheet.
std::unique_ptr<Drive> make_drive(const Problem& problem, Model& model, Newton& newton);

/// The load of a problem, from a bulged sheet in equilibrium.
std::unique_ptr<Drive> make_drive_from(const Problem& problem, Model& model, Newton& newton,
                                       const Eigen::VectorXd& bulged);

/// A pressure towards −z by its value, from the flat sheet.
std::unique_ptr<Drive> pressure_drive(const Problem& problem, Model& model, Newton& newton);

}  // namespace membrane
