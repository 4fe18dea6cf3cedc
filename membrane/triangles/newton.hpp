// Equilibrium under one pattern load at a prescribed force or conjugate depth.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "membrane/problem.hpp"
#include "membrane/terms/total_energy.hpp"
#include "membrane/triangles/factor.hpp"
#include "membrane/triangles/softest.hpp"

namespace membrane {

/// A conjugate depth D that is no linear function of the displacements (a pattern's is), with the force F of
/// its energy −F D, which is one of the terms of the total energy. Depths in Å, forces in eV/Å, of the meshed
/// part.
class CurvedDepth {
 public:
  virtual ~CurvedDepth() = default;

  virtual double force() const = 0;
  virtual void set_force(double force_eV_per_A) = 0;
  /// dD/du; what it says of held components does not matter.
  virtual Eigen::VectorXd direction(const Eigen::VectorXd& u) const = 0;
  /// Brings u to a depth by a change that vanishes with the distance from it.
  virtual void restore(double depth_A, Eigen::VectorXd& u) const = 0;
};

/// What is held on the way to an equilibrium. Forces are those on the meshed part.
struct Target {
  Control control = Control::conjugate_depth;
  double value = 0;               ///< Å or eV/Å
  CurvedDepth* curved = nullptr;  ///< whose depth is controlled; none: that of the pattern
};

/// How a search for an equilibrium ended.
struct Equilibrium {
  bool converged = false;
  std::string reason;                    ///< empty when converged
  double force_eV_per_A = 0;             ///< on the meshed part: given, or the multiplier of the depth
  double energy_eV = 0;                  ///< of the meshed part
  double relative_residual = 0;          ///< |free residual| / |applied load|
  std::vector<double> residual_history;  ///< the same before each step, and at the end
  int iterations = 0;                    ///< steps taken
  int smallest_pivot_sign = 1;           ///< of the last tangent that was factorised: −1 indefinite, 0 singular
  /// dd/dF of the last factor (Å²/eV), the slope of the path; 0 before the first factorisation.
  double compliance = 0;
};

/// Whether a search begins with a tangent of its own or with the factor that is there.
enum class FirstFactor { fresh, kept };

/// Newton's method with a line search on the potential energy. A factor is kept while the residual still
/// falls fast with it (chord steps). A controlled depth borders the system by the pattern: since it is linear
/// in u, every step from a start that has it keeps it, and the force is the multiplier. A curved depth is
/// restored after each step, and what the multiplier says is added to its force. An equilibrium has a
/// residual of at most the tolerance, and supports that carry the load to the same share.
class Newton {
 public:
  /// direction: dd/du of the load pattern (Pattern::direction); zero where energies or supports are all that loads the
  /// sheet: the residual is then measured by the supports' forces.
  Newton(TotalEnergy& energy, Eigen::VectorXd direction, Triangles options);

  /// Norm of other dead forces (eV/Å): the scale of a residual where the pattern's load is 0.
  void set_dead_load(double norm) { dead_load_ = norm; }

  /// Improves u in place. It has the target's depth (with conjugate depth control) and its held components already.
  Equilibrium solve(const Target& target, Eigen::VectorXd& u, FirstFactor first = FirstFactor::fresh);

  /// dU/du at the u that solve() left: held components are the supports' forces.
  const Eigen::VectorXd& gradient() const { return gradient_; }

  /// K⁻¹ of the tangent at u, on a vector whose held components are zero. Not finite where there is no tangent.
  Eigen::VectorXd linear_response(const Eigen::VectorXd& u, const Eigen::VectorXd& right_side);

  /// The softest direction at u, and a step along it where it leads down (softest.hpp); the depth stays what it is.
  Softest softest_at(const Eigen::VectorXd& u);
  bool leave_saddle(const Softest& direction, double smallest_A, Eigen::VectorXd& u);

  int factorisations() const { return factor_.count(); }

 private:
  bool refresh(const Eigen::VectorXd& u);
  bool factorise(const Eigen::VectorXd& u);
  double force_at(const Target& target) const;
  double load_norm(double force) const;
  bool balanced() const;
  void measure(const Target& target, Equilibrium& at);
  void adapt_damping(double step_length);
  bool move(const Target& target, Eigen::VectorXd& u);
  void follow_curve(const Target& target, const Eigen::VectorXd& u);

  TotalEnergy& total_;
  Triangles options_;
  Factor factor_;
  Eigen::VectorXd direction_;  ///< of the load, zero where held
  Eigen::VectorXd response_;   ///< K⁻¹ direction, with the factor kept
  double multiplier_ = 0;      ///< force along direction_, eV/Å; of a curved depth what its energy lacks of it
  double dead_load_ = 0;
  double energy_ = 0;
  int pivot_sign_ = 1;
  double damping_ = 0;  ///< share of the tangent's largest diagonal entry that is added to its diagonal
  Eigen::VectorXd gradient_, residual_, step_, trial_, trial_gradient_;
};

}  // namespace membrane
