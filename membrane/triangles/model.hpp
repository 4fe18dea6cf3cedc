// A problem made ready to solve: mesh, energies, and how its load acts on them.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "membrane/bending/term.hpp"
#include "membrane/loads/pattern.hpp"
#include "membrane/problem.hpp"
#include "membrane/terms/edge_line.hpp"
#include "membrane/terms/edge_tension.hpp"
#include "membrane/terms/obstacles.hpp"
#include "membrane/terms/pressure.hpp"
#include "membrane/terms/stretching.hpp"
#include "membrane/terms/total_energy.hpp"

namespace membrane {

/// The parts refer to each other: neither copied nor moved.
class Model {
 public:
  explicit Model(const Problem& problem);
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  const Mesh& mesh() const { return mesh_; }
  TotalEnergy& energy() { return *energy_; }
  Stretching& stretching() { return stretching_; }
  Pressure& pressure() { return pressure_; }
  const std::vector<Obstacle*>& obstacles() const { return obstacles_; }

  /// Weights over all nodes (the mesh's, an indenter's, those that carry rotations), whose sum of −z is the conjugate
  /// depth; zero for a load that has none (pressure, motion).
  const Pattern& pattern() const { return pattern_; }

  /// −z of every node; of one that carries rotations without a meaning.
  static Eigen::VectorXd transverse(const Eigen::VectorXd& u) {
    return -u.reshaped(3, u.size() / 3).row(2).transpose();
  }

  /// A sphere presses the sheet: its node is the last but those that carry rotations.
  bool has_sphere() const { return sphere_ != nullptr; }

  /// Pressure towards −z, eV/Å³.
  void set_pressure(double value) { pressure_.set(-value); }
  double pressure_towards_tip() const { return -pressure_.value(); }

  /// Number of the first node that carries rotations; that of all nodes where the sheet does not bend.
  int first_rotation_node() const { return mesh_.node_count() + (sphere_ ? 1 : 0); }
  /// Degree of freedom of a sphere's height.
  int indenter_dof() const { return 3 * mesh_.node_count() + 2; }

  /// Stretching or bending energy alone (eV), of the meshed part.
  double stretching_energy(const Eigen::VectorXd& u);
  double bending_energy(const Eigen::VectorXd& u);
  /// Potential of the edges' tension and of their own stress (eV), of the meshed part.
  double edge_potential(const Eigen::VectorXd& u) const {
    return line_.energy(u) - edge_.forces().dot(u.head(edge_.forces().size()));
  }
  const EdgeTension& edge() const { return edge_; }

  /// Puts the nodes of a moved edge where the level wants them.
  void move_edge(const EdgeMotion& motion, double level, Eigen::VectorXd& u) const;

  /// Puts a sphere, if there is one, where no bulge reaches it.
  void park_indenter(Eigen::VectorXd& u) const;

  /// Lowers the nodes that a sphere at its place in u, if there is one, has inside to its surface.
  void clear_sphere(Eigen::VectorXd& u) const;

 private:
  Mesh mesh_;
  Stretching stretching_;
  Pressure pressure_;
  EdgeTension edge_;
  EdgeLine line_;
  std::unique_ptr<BendingTerm> bending_;
  std::unique_ptr<SphereObstacle> sphere_;
  double sphere_radius_A_ = 0;
  std::unique_ptr<MirrorPlanes> planes_;
  std::vector<Obstacle*> obstacles_;
  std::unique_ptr<TotalEnergy> energy_;
  Pattern pattern_;
};

/// The law of a problem with its prestress, turned to its own axes where a round quarter is meshed: a round sheet of an
/// isotropic law looks the same from every side. Throws std::invalid_argument for a prestress the law cannot carry.
Material material_of(const Problem& problem, const Mesh& mesh);

/// Radius on which a load ends, or is likely to end for a sphere; 0 where it has none. Å.
double load_radius_A(const Load& load);

}  // namespace membrane
