#include "membrane/path/drive.hpp"

#include <cmath>
#include <utility>

#include "membrane/triangles/mean_depth.hpp"
#include "membrane/triangles/nested_start.hpp"
#include "membrane/triangles/predictor.hpp"
#include "membrane/triangles/start.hpp"
#include "membrane/triangles/tuning.hpp"

namespace membrane {
namespace {

using Eigen::VectorXd;

/// Rotations begin in the middle between their triangles.
VectorXd padded(Model& model, const VectorXd& of_nodes) {
  VectorXd all = VectorXd::Zero(model.energy().dof_count());
  all.head(of_nodes.size()) = of_nodes;
  return all;
}

/// Half way on the scale on which a sheet's response from flat is a straight line, the logarithmic one.
double half_way(double here, double value) { return here == 0 ? value / 8 : std::sqrt(here / value) * value; }

/// The load that gives a sheet under even tension Schwerin's shape w ~ 1 − (r/a)^(2/3), exact for a point load on a
/// sheet that stretches: density ∇²w ~ r^(−4/3), rounded over the tip. (Under a point itself an even tension would
/// answer by an infinite slope.) E. Schwerin, Z. angew. Math. Mech. 9 (1929) 482.
Pattern schwerin_pattern(const Mesh& mesh, double tip_radius) {
  double size = 0;
  for (const Eigen::Vector2d& X : mesh.nodes) size = std::max(size, X.norm());
  return radial_pattern(mesh, size, [&](double r) { return std::pow(r * r + tip_radius * tip_radius, -2.0 / 3); });
}

/// A pattern of dead forces, or a sphere, by its force or its conjugate depth.
class PatternDrive : public Drive {
 public:
  PatternDrive(const Problem& problem, Model& model, Newton& newton, Scaling scaling)
      : problem_(problem), model_(model), newton_(newton), predictor_(scaling, model.first_rotation_node()) {}

  VectorXd guess(double value) override {
    const bool by_force = problem_.control == Control::force;
    VectorXd u = predictor_.empty()
                     ? first_guess(value)
                     : predictor_.displacements(by_force ? predictor_.conjugate_depth(on_part(value)) : value);
    model_.clear_sphere(u);
    return u;
  }

  Target target(double value) override {
    return {problem_.control, problem_.control == Control::force ? on_part(value) : value};
  }

  void passed(double value, const Equilibrium& at, const VectorXd& u) override {
    value_ = value;
    predictor_.add({depth_of(u), at.force_eV_per_A, at.compliance, u});
  }

  double between(double value) const override { return half_way(value_, value); }
  const char* unit() const override { return problem_.control == Control::force ? "eV/Å" : "Å"; }
  double conjugate_depth(const VectorXd& u) const override { return depth_of(u); }

 protected:
  double on_part(double force) const { return force / model_.mesh().copies; }
  double depth_of(const VectorXd& u) const { return model_.pattern().weights.dot(Model::transverse(u)); }

  /// Schwerin's shape, as far as the force or the depth wants it. A sphere is put where the centre has gone.
  VectorXd first_guess(double value) {
    const VectorXd forces = padded(schwerin_pattern(model_.mesh(), load_radius_A(problem_.load)).direction());
    const VectorXd shape = StiffenedSheet(model_, newton_).under_forces(forces);
    const bool sphere = model_.has_sphere();
    const Pattern tip = sphere ? Pattern{mean_on_circle(model_.mesh(), 0)} : model_.pattern();
    const double depth = padded(tip.direction()).dot(shape);
    const double amplitude =
        problem_.control == Control::force ? balanced_amplitude(model_, shape, on_part(value) * forces) : value / depth;
    VectorXd u = amplitude * shape;
    if (sphere) u[model_.indenter_dof()] = -amplitude * depth;
    return u;
  }

  /// With the degrees of freedom of an indenter, if there is one, at zero.
  VectorXd padded(const VectorXd& of_nodes) const {
    VectorXd all = VectorXd::Zero(model_.energy().dof_count());
    all.head(of_nodes.size()) = of_nodes;
    return all;
  }

  const Problem& problem_;
  Model& model_;
  Newton& newton_;
  Predictor predictor_;
  double value_ = 0;
};

/// The same on a sheet that is bulged already, which is where the path begins.
class BulgedPatternDrive final : public PatternDrive {
 public:
  BulgedPatternDrive(const Problem& problem, Model& model, Newton& newton, VectorXd bulged)
      : PatternDrive(problem, model, newton, from_bulged) {
    if (model.has_sphere()) {  // it touches the highest node
      const VectorXd transverse = Model::transverse(bulged).head(model.mesh().node_count());
      bulged[model.indenter_dof()] = -transverse.minCoeff();
    }
    value_ = problem.control == Control::force ? 0 : depth_of(bulged);
    predictor_.add({depth_of(bulged), 0, 0, std::move(bulged)});
  }

  VectorXd guess(double value) override {
    VectorXd u = predictor_.last().u;
    if (problem_.control == Control::force) return u;  // there is no power law to extrapolate
    if (predictor_.size() > 1) u = predictor_.displacements(value);
    move_to_depth(value, u);
    return u;
  }

  double between(double value) const override { return 0.5 * (value_ + value); }

 private:
  void move_to_depth(double depth, VectorXd& u) {
    if (model_.has_sphere()) {
      u[model_.indenter_dof()] = -depth;
      model_.clear_sphere(u);
      return;
    }
    const VectorXd direction = model_.pattern().direction();
    const VectorXd response = newton_.linear_response(u, direction);
    u += response * ((depth - depth_of(u)) / direction.dot(response));
  }
};

/// A pressure towards −z, by its value or by the mean depth V/A, which is conjugate to the force p A.
class PressureDrive final : public Drive {
 public:
  /// nested: the pressure is the problem's load, so that coarser sheets can be asked where it leads.
  PressureDrive(const Problem& problem, Control control, bool nested, Model& model, Newton& newton)
      : problem_(problem), control_(control), nested_(nested), model_(model), newton_(newton) {}

  VectorXd guess(double value) override {
    sign_ = value < 0 ? -1 : 1;
    if (control_ == Control::force)
      model_.set_pressure(value);
    else
      depth_.set_force(predictor_.empty() ? 0 : predictor_.last().force_eV_per_A);
    if (!predictor_.empty())
      return predictor_.displacements(control_ == Control::force ? predictor_.conjugate_depth(std::abs(value) * area_)
                                                                 : value);
    if (nested_)
      if (const auto guess = guess_from_coarser(problem_, value, StartTuning::cells_for_tucks))
        return padded(model_, *guess);
    return first_guess(value);
  }

  Target target(double value) override {
    if (control_ == Control::force) return {Control::force, 0};
    return {Control::conjugate_depth, value, &depth_};
  }

  void passed(double value, const Equilibrium&, const VectorXd& u) override {
    value_ = value;
    predictor_.add({sign_ * depth_.of(u), sign_ * depth_.force(), 0, u});
  }

  double between(double value) const override { return half_way(value_, value); }
  const char* unit() const override { return control_ == Control::force ? "eV/Å³" : "Å of mean depth"; }
  double conjugate_depth(const VectorXd& u) const override { return depth_.of(u); }

 private:
  /// The flat sheet's answer to the load, as far as the pressure wants it; a volume is restored by Newton's
  /// method.
  VectorXd first_guess(double value) {
    const VectorXd flat = VectorXd::Zero(model_.energy().dof_count());
    const VectorXd unit = sign_ * area_ * depth_.direction(flat);
    model_.set_pressure(0);
    const VectorXd shape = StiffenedSheet(model_, newton_).under_forces(unit);
    if (control_ == Control::conjugate_depth) return value / depth_.of(shape) * shape;
    VectorXd u = balanced_amplitude(model_, shape, std::abs(value) * unit) * shape;
    model_.set_pressure(value);
    model_.park_indenter(u);
    return u;
  }

  const Problem& problem_;
  Control control_;
  bool nested_;
  Model& model_;
  Newton& newton_;
  Predictor predictor_{from_flat, model_.first_rotation_node()};
  double area_ = model_.mesh().area_A2();
  MeanDepth depth_{model_};
  double value_ = 0;
  double sign_ = 1;
};

/// A clamped edge that moves.
class MotionDrive final : public Drive {
 public:
  MotionDrive(const Problem& problem, const EdgeMotion& motion, Model& model, Newton& newton)
      : problem_(problem), motion_(motion), model_(model), newton_(newton) {}

  VectorXd guess(double value) override {
    VectorXd u = predictor_.empty() ? first_guess(value) : predictor_.displacements(value);
    model_.move_edge(motion_, value, u);
    return u;
  }

  Target target(double) override { return {Control::force, 0}; }
  void passed(double value, const Equilibrium&, const VectorXd& u) override {
    value_ = value;
    predictor_.add({value, 0, 0, u});
  }
  double between(double value) const override { return half_way(value_, value); }
  const char* unit() const override { return "× the motion"; }
  double conjugate_depth(const VectorXd&) const override { return 0; }
  const EdgeMotion* motion() const override { return &motion_; }

 private:
  VectorXd first_guess(double value) {
    if (const auto guess = guess_from_coarser(problem_, value, StartTuning::cells_in_plane))
      return padded(model_, *guess);
    VectorXd held = VectorXd::Zero(model_.energy().dof_count());
    model_.move_edge(motion_, value, held);
    return StiffenedSheet(model_, newton_).under_motion(held);
  }

  const Problem& problem_;
  EdgeMotion motion_;
  Model& model_;
  Newton& newton_;
  Predictor predictor_{with_motion};
  double value_ = 0;
};

struct DriveOf {
  const Problem& problem;
  Model& model;
  Newton& newton;

  using Made = std::unique_ptr<Drive>;
  Made operator()(const CentreForce&) const { return pattern(); }
  Made operator()(const SpreadForce&) const { return pattern(); }
  Made operator()(const RigidSphere&) const { return pattern(); }
  Made operator()(const FollowerPressure&) const {
    return std::make_unique<PressureDrive>(problem, problem.control, true, model, newton);
  }
  Made operator()(const EdgeMotion& motion) const {
    return std::make_unique<MotionDrive>(problem, motion, model, newton);
  }

 private:
  Made pattern() const { return std::make_unique<PatternDrive>(problem, model, newton, from_flat); }
};

}  // namespace

std::unique_ptr<Drive> make_drive(const Problem& problem, Model& model, Newton& newton) {
  return std::visit(DriveOf{problem, model, newton}, action_of(problem.load));
}

std::unique_ptr<Drive> make_drive_from(const Problem& problem, Model& model, Newton& newton, const VectorXd& bulged) {
  return std::make_unique<BulgedPatternDrive>(problem, model, newton, bulged);
}

std::unique_ptr<Drive> pressure_drive(const Problem& problem, Model& model, Newton& newton) {
  return std::make_unique<PressureDrive>(problem, Control::force, false, model, newton);
}

}  // namespace membrane
