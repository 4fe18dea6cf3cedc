// Equilibrium under one pattern load at a prescribed force or conjugate depth.
#pragma once

#include <Eigen/Core>
#include <string>

#include "membrane/assembly.hpp"
#include "membrane/factor.hpp"
#include "membrane/problem.hpp"

namespace membrane {

/// What is held on the way to an equilibrium. Forces are those on the meshed part.
struct Target {
  Control control = Control::conjugate_depth;
  double value = 0;  ///< Å or eV/Å
};

/// How a search for an equilibrium ended.
struct Equilibrium {
  bool converged = false;
  std::string reason;            ///< empty when converged
  double force_eV_per_A = 0;     ///< on the meshed part: given, or the multiplier of the depth
  double energy_eV = 0;          ///< of the meshed part
  double relative_residual = 0;  ///< |free residual| / |applied load|
  int iterations = 0;            ///< steps taken
  /// dd/dF of the last factor (Å²/eV), the slope of the path; 0 before the first factorisation.
  double compliance = 0;
};

/// Newton's method with a line search on the potential energy. A factor is kept while the residual still
/// falls fast with it (chord steps). A controlled depth borders the system by the pattern: since it is linear
/// in u, every step from a start that has it keeps it, and the force is the multiplier.
class Newton {
 public:
  /// direction: dd/du of the load pattern (Pattern::direction).
  Newton(const Mesh& mesh, Assembly& assembly, Eigen::VectorXd direction);

  /// Improves u (held components zero, and with conjugate depth control Pattern depth = target) in place.
  Equilibrium solve(const Target& target, Eigen::VectorXd& u);

  int factorisations() const { return factor_.count(); }

 private:
  bool refresh(const Eigen::VectorXd& u);
  double force_at(const Target& target) const;
  void measure(const Target& target, Equilibrium& at);
  bool line_search(double force, Eigen::VectorXd& u);
  void release_held(Eigen::VectorXd& vector) const;

  const Mesh& mesh_;
  Assembly& assembly_;
  Factor factor_;
  Eigen::VectorXd direction_;  ///< of the load, zero where held
  Eigen::VectorXd response_;   ///< K⁻¹ direction, with the factor kept
  double energy_ = 0;
  Eigen::VectorXd gradient_, residual_, step_, trial_, trial_gradient_;
};

}  // namespace membrane
