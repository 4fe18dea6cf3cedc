#include "atomistic/thermal/quasi_harmonic.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "atomistic/equilibrium/indentation.hpp"
#include "atomistic/loads/load_term.hpp"
#include "atomistic/thermal/free_energy.hpp"
#include "atomistic/thermal/hessian.hpp"
#include "atomistic/thermal/modes.hpp"

namespace atomistic {

using Eigen::VectorXd;

namespace {

/// The two sheets of a central difference lie so far from the level, as a share of its force or depth.
constexpr double share_of_level = 0.02;

/// Wider patterns are tried until a random direction is reproduced this well …
constexpr double enough_of_the_hessian = 1e-5;
constexpr int narrowest_reach_bonds = 2, widest_reach_bonds = 4;  // … or this far

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// One level on rank 0.
class Heating {
 public:
  Heating(const Problem& problem, const Sheet& sheet, ForceField& forces, const Heat& heat)
      : problem_(problem), sheet_(sheet), forces_(forces), heat_(heat), energy_(heat, problem.potential.mass) {
    if (problem_.control == Control::conjugate_depth && acts_by_force()) held_.control = Control::force;
    if (problem_.control == Control::force && !acts_by_force()) held_.control = Control::conjugate_depth;
    load_ = make_load(held_, sheet_);
  }

  HeatedLevel operator()(const Step& step) {
    const double start = seconds_now();
    const long calls = forces_.timing().calls;
    HeatedLevel level;
    level.level = step.level;
    level.force_eV_per_A = step.force_eV_per_A;
    level.conjugate_depth_A = step.conjugate_depth_A;
    positions_ = step.positions;
    parameter_ = parameter_of(step);
    const VectorXd x = positions_.head(3 * sheet_.free_atoms);
    const Hessian here = checked_hessian(x, level);
    heat(x, here, level);
    add_modes(here, level);
    level.reach_bonds = coupling_->reach_bonds();
    level.colours = coupling_->colours();
    level.force_calls = forces_.timing().calls - calls;
    level.seconds = seconds_now() - start;
    return level;
  }

 private:
  bool acts_by_force() const { return !std::holds_alternative<SphereLoad>(problem_.load); }

  /// What is varied along the path: a force, a pressure or a sphere's place.
  double parameter_of(const Step& step) const {
    if (std::holds_alternative<PressureLoad>(problem_.load)) return step.target;
    return acts_by_force() ? step.force_eV_per_A : step.conjugate_depth_A;
  }

  VectorXd gradient(const VectorXd& x, double parameter) {
    positions_.head(x.size()) = x;
    forces_.evaluate(positions_, atom_forces_, std::exchange(fresh_, false));
    VectorXd g = -atom_forces_.head(x.size());
    load_->set_level(parameter);
    load_->add(x, g);
    return g;
  }

  Hessian hessian_at(const VectorXd& x, double parameter) {
    return hessian([&](const VectorXd& y) { return gradient(y, parameter); }, *coupling_, x);
  }

  Hessian checked_hessian(const VectorXd& x, HeatedLevel& level) {
    if (!coupling_) coupling_ = std::make_unique<Coupling>(sheet_, narrowest_reach_bonds);
    for (;;) {
      fresh_ = true;
      Hessian made = hessian_at(x, parameter_);
      level.hessian_error_relative = missed_by(
          made, [&](const VectorXd& y) { return gradient(y, parameter_); }, x);
      if (level.hessian_error_relative <= enough_of_the_hessian || coupling_->reach_bonds() >= widest_reach_bonds)
        return made;
      coupling_ = std::make_unique<Coupling>(sheet_, coupling_->reach_bonds() + 1);
    }
  }

  /// ∂g/∂parameter: of a pattern minus its unit load.
  VectorXd pull(const VectorXd& x) {
    const double small = 1e-4 * parameter_;
    VectorXd ahead = VectorXd::Zero(x.size()), behind = ahead;
    load_->set_level(parameter_ + small);
    load_->add(x, ahead);
    load_->set_level(parameter_ - small);
    load_->add(x, behind);
    return (ahead - behind) / (2 * small);
  }

  struct Place {
    VibrationEnergy energy;
    double force = 0, depth = 0;
  };

  std::optional<Place> moved(const VectorXd& x, const VectorXd& response, const VectorXd& c, double by) {
    const VectorXd y = x + by * response;
    const auto energy = energy_(hessian_at(y, parameter_ + by).matrix, c, factor_);
    if (!energy) return std::nullopt;
    load_->set_level(parameter_ + by);
    return Place{*energy, load_->force(y, 0), load_->conjugate_depth(y)};
  }

  void heat(const VectorXd& x, const Hessian& here, HeatedLevel& level) {
    if (!factor_.factorise(here.matrix)) return;
    const VectorXd response = -factor_.solve(pull(x));
    const bool pattern = acts_by_force() && !std::holds_alternative<PressureLoad>(problem_.load);
    const VectorXd c = pattern ? pull(x) : VectorXd();
    const double by = share_of_level * parameter_;
    const auto ahead = moved(x, response, c, by), behind = moved(x, response, c, -by);
    if (!ahead || !behind) return;
    level.stable = true;
    const double d_force = ahead->force - behind->force, d_depth = ahead->depth - behind->depth;
    level.compliance_A2_per_eV = d_depth / d_force;
    level.depth_shift_A = -(ahead->energy.free_eV - behind->energy.free_eV) / d_force;
    level.force_shift_eV_per_A = (ahead->energy.held_eV - behind->energy.held_eV) / d_depth;
  }

  void add_modes(const Hessian& here, HeatedLevel& level) {
    const Eigenpairs lowest = lowest_modes(here.matrix, std::max(1, heat_.modes));
    level.lowest_eigenvalue_eV_per_A2 = lowest.values.front();
    for (std::size_t k = 0; k < lowest.values.size(); ++k)
      level.modes.push_back(mode_of(lowest.values[k], lowest.vectors[k]));
  }

  Mode mode_of(double eigenvalue, const VectorXd& shape) const {
    Mode mode{.eigenvalue_eV_per_A2 = eigenvalue,
              .frequency_THz = frequency_THz(eigenvalue, problem_.potential.mass),
              .out_of_plane = 0,
              .radius_A = 0,
              .shape = {shape.data(), shape.data() + shape.size()}};
    for (int i = 0; i < sheet_.free_atoms; ++i) {
      mode.out_of_plane += shape[3 * i + 2] * shape[3 * i + 2];
      mode.radius_A += shape.segment<3>(3 * i).squaredNorm() * sheet_.position(i).head<2>().norm();
    }
    return mode;
  }

  const Problem& problem_;
  Problem held_ = problem_;  ///< its load varied by its own parameter
  const Sheet& sheet_;
  ForceField& forces_;
  Heat heat_;
  VibrationalFreeEnergy energy_;
  std::unique_ptr<LoadTerm> load_;
  std::unique_ptr<Coupling> coupling_;
  DefiniteFactor factor_;
  VectorXd positions_, atom_forces_;
  double parameter_ = 0;
  bool fresh_ = true;
};

}  // namespace

void heat_levels(const Problem& problem, const std::vector<Step>& steps, const Heat& heat, const std::string& log_file,
                 const std::vector<int>& done, const std::function<void(const HeatedLevel&)>& on_level,
                 const MpiSession& session) {
  if (problem.form.edge == Edge::sliding) throw std::invalid_argument("heat: the edge of the sheet must be clamped");
  const Sheet sheet = make_sheet(problem);
  ForceField forces(problem.potential, box_around(sheet), sheet.positions, log_file);
  if (session.rank() != 0) return forces.serve();
  Heating heating(problem, sheet, forces, heat);
  for (const Step& step : steps)
    if (std::find(done.begin(), done.end(), step.level) == done.end()) on_level(heating(step));
}

}  // namespace atomistic
