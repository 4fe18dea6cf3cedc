#include "membrane/path/load_path.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "membrane/follow_levels.hpp"
#include "membrane/laws/principal.hpp"
#include "membrane/path/drive.hpp"
#include "membrane/problem.hpp"
#include "membrane/triangles/model.hpp"
#include "membrane/triangles/newton.hpp"
#include "membrane/triangles/predictor.hpp"
#include "membrane/triangles/start.hpp"
#include "membrane/triangles/tautness.hpp"
#include "membrane/triangles/tuning.hpp"

namespace membrane {
namespace {

/// Where a search for an equilibrium ended, converged or not.
struct Attempt {
  Equilibrium equilibrium;
  Eigen::VectorXd u;                             ///< Å
  std::optional<double> softest, first_softest;  ///< as in TriangleShape
  int saddles_left = 0;
};

class LoadPath {
 public:
  explicit LoadPath(const Problem& problem)
      : problem_(problem),
        model_(problem),
        record_(mean_on_circle(model_.mesh(), problem.record_radius_A)),
        newton_(model_.energy(), model_.pattern().direction(), std::get<Triangles>(problem.discretisation)) {}

  Report follow(const OnStep& on_step) {
    report_.elements = static_cast<int>(model_.mesh().triangles.size());
    if (begin()) go_through_levels(on_step);
    report_.factorisations = newton_.factorisations();
    report_.assemblies = model_.energy().passes();
    return report_;
  }

 private:
  /// What is there before the load comes first: the edges' tension, the constant pressure, as a path of its own.
  bool begin() {
    if (problem_.edge_tension_eV_per_A2 > 0) return stretch();
    return inflate();
  }

  /// The flat sheet, its edges pulled outwards.
  bool stretch() {
    newton_.set_dead_load(model_.edge().forces().norm());
    Eigen::VectorXd u = evenly_stretched(model_, problem_.edge_tension_eV_per_A2);
    const Equilibrium at = newton_.solve({Control::force, 0}, u);
    if (!at.converged) {
      report_.reason = "the edges' tension: " + at.reason;
      return false;
    }
    flat_energy_ = model_.stretching_energy(u) + model_.edge_potential(u);
    drive_ = make_drive_from(problem_, model_, newton_, std::move(u));
    return true;
  }

  bool inflate() {
    if (problem_.pressure_eV_per_A3 == 0) {
      drive_ = make_drive(problem_, model_, newton_);
      return true;
    }
    drive_ = pressure_drive(problem_, model_, newton_);
    const Attempt end = reach(problem_.pressure_eV_per_A3);
    if (!end.equilibrium.converged) {
      report_.reason = "the constant pressure: " + end.equilibrium.reason;
      return false;
    }
    drive_ = make_drive_from(problem_, model_, newton_, end.u);
    return true;
  }

  void go_through_levels(const OnStep& on_step) {
    follow_levels(
        problem_.levels, drive_->unit(), on_step, report_,
        [&](double level) {
          iterations_ = 0;
          return reach(level);
        },
        [&](int level, const Attempt& end) { return step(level, end); });
  }

  Attempt reach(double level) {
    return membrane::reach(
        level, [&](double value) { return attempt(value); }, [&](double value) { return drive_->between(value); },
        [](int cuts) { return cuts < PathTuning::most_cuts; },
        [&](double missed, double next, const Equilibrium& why) {
          report_.cuts.push_back(cut_note(missed, next, why));
        });
  }

  Attempt attempt(double value) {
    Attempt attempt{{}, drive_->guess(value)};
    attempt.equilibrium = settle(drive_->target(value), attempt.u);
    iterations_ += attempt.equilibrium.iterations;
    if (problem_.bending) leave_saddles(drive_->target(value), attempt);
    if (attempt.equilibrium.converged) drive_->passed(value, attempt.equilibrium, attempt.u);
    return attempt;
  }

  /// A sheet that could wrinkle need not: Newton's method stays on the branch that it came along. From a saddle it goes
  /// down along the softest direction.
  void leave_saddles(const Target& target, Attempt& attempt) {
    const double length = std::sqrt(problem_.bending->mean_eV / sheet_modulus(problem_.law));
    while (attempt.equilibrium.converged) {
      const Softest direction = newton_.softest_at(attempt.u);
      attempt.softest = direction.stiffness_eV_per_A2;
      if (!attempt.first_softest) attempt.first_softest = attempt.softest;
      if (attempt.saddles_left == SoftestTuning::most_saddles) return;
      if (!newton_.leave_saddle(direction, SoftestTuning::first_step * length, attempt.u)) return;
      ++attempt.saddles_left;
      attempt.equilibrium = settle(target, attempt.u);
      iterations_ += attempt.equilibrium.iterations;
    }
  }

  /// Equilibrium with the contact forces that belong to it.
  Equilibrium settle(const Target& target, Eigen::VectorXd& u) {
    Equilibrium at = newton_.solve(target, u);
    int iterations = at.iterations;
    for (int round = 0; at.converged && round < ContactTuning::most_rounds; ++round) {
      bool settled = true;
      for (Obstacle* obstacle : model_.obstacles())
        if (obstacle->update_multipliers(u) > obstacle->tolerance_A()) settled = false;
      if (settled) break;
      at = newton_.solve(target, u, FirstFactor::kept);
      iterations += at.iterations;
      if (round + 1 == ContactTuning::most_rounds && at.converged) {
        at.converged = false;
        at.reason = "the contact does not settle";
      }
    }
    at.iterations = iterations;
    return at;
  }

  double rim_membrane_force(const Eigen::VectorXd& u) {
    const Mesh& mesh = model_.mesh();
    double largest = 0;
    for (int t : mesh.rim_triangles) {
      const Voigt force = membrane_force(model_.stretching().material(), strain_of(mesh.triangles[t], u));
      largest = std::max(largest, principal_forces(force).larger);
    }
    return largest;
  }

  /// What the supports do: forces on all nodes they hold, and their sum over the full sheet.
  void add_reactions(Step& step, TriangleShape& shape) const {
    const Mesh& mesh = model_.mesh();
    shape.reactions = Eigen::VectorXd::Zero(3 * mesh.node_count());
    for (int n = 0; n < mesh.node_count(); ++n)
      for (int c = 0; c < 3; ++c)
        if (mesh.held[n][c]) shape.reactions[3 * n + c] = newton_.gradient()[3 * n + c];
    step.support_force_eV_per_A = mesh.copies * shape.reactions.reshaped(3, mesh.node_count()).rowwise().sum();
    if (mesh.copies > 1) step.support_force_eV_per_A.head<2>().setZero();
    if (const EdgeMotion* motion = drive_->motion()) add_edge_reaction(*motion, shape, step);
  }

  void add_edge_reaction(const EdgeMotion& motion, const TriangleShape& shape, Step& step) const {
    const Mesh& mesh = model_.mesh();
    const double level = problem_.levels[step.level];
    const Eigen::Vector2d pivot = motion.pivot_A + level * motion.translation_A.head<2>();
    for (int node : mesh.edges.at(motion.edge)) {
      const Eigen::Vector3d force = shape.reactions.segment<3>(3 * node);
      const Eigen::Vector2d arm = mesh.nodes[node] + shape.displacements.segment<2>(3 * node) - pivot;
      step.edge_force_eV_per_A += force;
      step.edge_torque_eV += arm.x() * force.y() - arm.y() * force.x();
    }
  }

  Step step(int level, const Attempt& end) {
    const Mesh& mesh = model_.mesh();
    const int copies = mesh.copies;
    const Equilibrium& at = end.equilibrium;
    const Eigen::VectorXd transverse = Model::transverse(end.u);
    Step step;
    step.level = level;
    step.converged = at.converged;
    step.depth_A = record_.dot(transverse.head(mesh.node_count()));
    step.conjugate_depth_A = drive_->conjugate_depth(end.u);
    step.force_eV_per_A = copies * at.force_eV_per_A;
    step.pressure_eV_per_A3 = model_.pressure_towards_tip();
    step.volume_A3 = -copies * model_.pressure().volume(end.u);
    step.bending_energy_eV = copies * model_.bending_energy(end.u);
    step.energy_eV = copies * (model_.stretching_energy(end.u) + model_.edge_potential(end.u) - flat_energy_) +
                     step.bending_energy_eV;
    step.relative_residual = at.relative_residual;
    for (const Obstacle* obstacle : model_.obstacles())
      step.penetration_A = std::max(step.penetration_A, obstacle->penetration(end.u));
    step.rim_membrane_force_eV_per_A2 = rim_membrane_force(end.u);
    step.rim_displacement_A = mean_outward_on_rim(mesh, end.u);
    step.tautness = tautness_of(mesh, model_.stretching().material(), end.u);
    step.newton_iterations = iterations_;
    TriangleShape shape{.displacements = end.u.head(3 * mesh.node_count()),
                        .reactions = {},
                        .residual_history = at.residual_history,
                        .smallest_pivot_sign = at.smallest_pivot_sign,
                        .softest_eV_per_A2 = end.softest,
                        .first_softest_eV_per_A2 = end.first_softest,
                        .saddles_left = end.saddles_left};
    add_reactions(step, shape);
    step.shape = std::move(shape);
    return step;
  }

  const Problem& problem_;
  Model model_;
  Eigen::VectorXd record_;
  Newton newton_;
  std::unique_ptr<Drive> drive_;
  Report report_;
  double flat_energy_ = 0;  ///< of the flat sheet under its edges' tension, of the meshed part
  int iterations_ = 0;      ///< on the way to the present level, cut-backs included
};

}  // namespace

Report follow_on_triangles(const Problem& problem, const OnStep& on_step) { return LoadPath(problem).follow(on_step); }

}  // namespace membrane
