// A rigid frictionless sphere on the axis, in contact with atoms through the force K (radius − r)² of LAMMPS's
// `fix indent`.
#pragma once

#include <vector>

#include "atomistic/loads/load_term.hpp"

namespace atomistic {

/// Held depth: the sphere's lowest point is at z = −level. Held force: the sphere sinks until the contact carries the
/// level; its place d*(x) minimises contact energy − F d for the atoms' positions, so that by the envelope theorem the
/// energy's gradient is the contact's alone.
class SphereTerm : public LoadTerm {
 public:
  /// Throws std::invalid_argument if the sphere is as wide as the sheet or its numbers are not positive.
  SphereTerm(const SphereLoad& sphere, const Problem& problem, const Sheet& sheet, const Team& team = alone);

  void set_level(double level) override { level_ = level; }
  void set_stiffness(double eV_per_A3) { sphere_.stiffness_eV_per_A3 = eV_per_A3; }
  double add(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) override;
  double conjugate_depth(const Eigen::VectorXd& x) override { return travel(x); }
  double force(const Eigen::VectorXd& x, double) override { return contact_at(x, travel(x)).force; }
  double dead_work(const Eigen::VectorXd& x) override { return held_force() ? -level_ * travel(x) : 0.0; }
  double parameter(double level) const override;
  Eigen::VectorXd first_guess() const override;
  void admit(Eigen::VectorXd& x) override;
  std::vector<AtomStiffness> stiffness(const Eigen::VectorXd& x) override;
  Eigen::VectorXd given_back(const Eigen::VectorXd& x) override;

  double deepest_penetration(const Eigen::VectorXd& x) { return contact_at(x, travel(x)).deepest; }

 private:
  /// Sums over the atoms inside the sphere at a travel.
  struct Contact {
    double energy = 0, force = 0, stiffness = 0;  ///< force and stiffness along the axis
    double deepest = 0;
  };

  bool held_force() const { return problem_.control == Control::force; }
  Eigen::Vector3d centre(double travel) const { return {0, 0, sphere_.radius_A - travel}; }
  Contact contact_at(const Eigen::VectorXd& x, double travel) const;
  double travel(const Eigen::VectorXd& x) const;  ///< the level, or where the contact carries it
  template <class Visit>
  void visit_contacts(const Eigen::VectorXd& x, double travel, Visit&& visit) const;

  SphereLoad sphere_;
  const Problem& problem_;
  const Sheet& sheet_;
  const Team& team_;
  std::vector<int> candidates_;  ///< atoms that the sphere may meet
  double level_ = 0;
};

}  // namespace atomistic
