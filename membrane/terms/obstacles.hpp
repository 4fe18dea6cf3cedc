// Rigid frictionless obstacles: a spherical tip, and the symmetry planes that a sheet must not cross.
#pragma once

#include <algorithm>
#include <vector>

#include "membrane/sheets/mesh.hpp"
#include "membrane/terms/term.hpp"

namespace membrane {

/// One node kept out of one obstacle by the augmented Lagrangian (Alart & Curnier, Comput. Methods Appl. Mech. Eng. 92
/// (1991) 353): energy (⟨λ − k g⟩² − λ²)/2k with the gap g and the present multiplier λ ≥ 0, the contact force.
/// Updating λ ← ⟨λ − k g⟩ at each equilibrium drives penetration to zero at finite stiffness.
struct Contact {
  double stiffness = 0;   ///< k, eV/Å²
  double multiplier = 0;  ///< λ, eV/Å

  double force(double gap) const { return std::max(0.0, multiplier - stiffness * gap); }
  double energy(double force) const { return (force * force - multiplier * multiplier) / (2 * stiffness); }
};

/// Shared by the obstacles: equilibrium with the present multipliers, update, until nothing penetrates.
class Obstacle : public EnergyTerm {
 public:
  /// λ ← ⟨λ − k g⟩. Returns the largest change of a gap that this corrects, in Å: penetration, or force at a distance.
  virtual double update_multipliers(const Eigen::VectorXd& u) = 0;
  /// Deepest penetration of a node, Å.
  virtual double penetration(const Eigen::VectorXd& u) const = 0;
  /// What update_multipliers() may return when the contact is settled, Å.
  virtual double tolerance_A() const = 0;
};

/// Sphere over the sheet, touching z = 0 from above at depth 0. Its displacement is that of an additional node, whose
/// number is the mesh's node count: its depth is conjugate to the force on it. The gap of a node is measured along z to
/// the lower hemisphere, and to a cone that continues it beyond 0.98 of the radius (a contact angle of 78°): unlike the
/// distance from the centre, it cannot take a node that lies above the sphere for one that is outside.
class SphereObstacle final : public Obstacle {
 public:
  SphereObstacle(const Mesh& mesh, double radius_A, double stiffness_eV_per_A2);

  void couple(NodePairs& pairs) const override;
  void locate(const Hessian& hessian) override;
  double add_gradient(const Eigen::VectorXd& u, Eigen::VectorXd& gradient) override;
  void add_hessian(const Eigen::VectorXd& u, double share, Hessian& hessian) override;
  double update_multipliers(const Eigen::VectorXd& u) override;
  double penetration(const Eigen::VectorXd& u) const override;
  double tolerance_A() const override { return 1e-7 * radius_A_; }

 private:
  struct Candidate {
    int node;
    Contact contact;
    Hessian::Place place;  ///< (indenter, node)
  };
  struct Gap {
    double value;               ///< Å
    Eigen::Vector3d gradient;   ///< with respect to the node's position; the indenter's is its z component's negative
    Eigen::Matrix2d curvature;  ///< second derivatives with respect to the node's x and y, 1/Å
  };
  Gap gap(const Candidate& at, const Eigen::VectorXd& u) const;

  const Mesh& mesh_;
  double radius_A_;
  int indenter_;
  std::vector<Candidate> candidates_;
};

/// Keeps every node of a part on its side of the symmetry planes x = 0 and y = 0 (Mesh::mirrored): beyond them it would
/// pass through its own mirror image.
class MirrorPlanes final : public Obstacle {
 public:
  MirrorPlanes(const Mesh& mesh, double stiffness_eV_per_A2);

  void couple(NodePairs&) const override {}
  void locate(const Hessian&) override {}
  double add_gradient(const Eigen::VectorXd& u, Eigen::VectorXd& gradient) override;
  void add_hessian(const Eigen::VectorXd& u, double share, Hessian& hessian) override;
  double update_multipliers(const Eigen::VectorXd& u) override;
  double penetration(const Eigen::VectorXd& u) const override;
  double tolerance_A() const override { return tolerance_A_; }

 private:
  struct Candidate {
    int node, component;
    Contact contact;
  };
  double gap(const Candidate& at, const Eigen::VectorXd& u) const;

  const Mesh& mesh_;
  double tolerance_A_;
  std::vector<Candidate> candidates_;
};

}  // namespace membrane
