// The path, on rank 0 or on every rank with its part of the sheet: level after level, each predicted from the states
// before it and minimised.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "atomistic/equilibrium/break_search.hpp"
#include "atomistic/equilibrium/indentation.hpp"
#include "atomistic/equilibrium/minimiser.hpp"
#include "atomistic/equilibrium/preconditioner.hpp"
#include "atomistic/equilibrium/predictor.hpp"
#include "atomistic/equilibrium/shared_sheet.hpp"
#include "atomistic/loads/load_term.hpp"

namespace atomistic {

/// A search that has pulled two neighbours this far apart, or an atom this many radii down, will not bring
/// them back: no first guess starts there, and what follows is the flight of fragments out of the box.
constexpr double torn_bond_A = 5.0, torn_depth_of_radius = 2.0;

class Path {
 public:
  /// Of a whole sheet, on rank 0.
  Path(const Problem& problem, const Sheet& sheet, ForceField& forces, const PathCallbacks& callbacks);

  /// Of a shared one, on every rank; rank 0 calls back.
  Path(const Problem& problem, const SharedSheet& sheet, ForceField& forces, const PathCallbacks& callbacks);

  /// `finished`: steps of the whole sheet.
  Report follow(const std::vector<Step>& finished);

 private:
  /// Where the path goes next: up through the levels, then between the last two if the sheet broke, or back if asked
  /// for.
  struct Target {
    double level;
    bool unloading = false, search = false;
  };

  Path(const Problem& problem, const Sheet& sheet, const SharedSheet* shared, Preconditioner preconditioner,
       ForceField& forces, const PathCallbacks& callbacks);

  const Team& team() const { return shared_ ? shared_->team() : alone; }
  double dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const { return team().sum(a.dot(b)); }
  double mean_record_depth(const Eigen::VectorXd& x) const;
  double longest() const;
  double evaluate(const Eigen::VectorXd& positions, bool fresh);
  void refresh();
  void tell(const Step& step) const;

  int free_dofs() const { return 3 * sheet_.free_atoms; }
  Eigen::VectorXd free_positions() const { return positions_.head(free_dofs()); }
  double tolerance() const { return problem_.force_tolerance_eV_per_A; }

  void relax_flat_sheet();
  std::optional<Target> next_target();
  void take_over(const std::vector<Step>& finished);
  void remember(const Step& step);
  void factorise(const Eigen::VectorXd& positions);
  std::optional<Eigen::VectorXd> guide(double level) const;
  void predict(int number, double level);
  void meet_constraint(double level);
  void hold_what_slides(Eigen::VectorXd& gradient) const;
  double pull(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) const;
  Minimisation minimisation();
  MinimiserReport minimise_level(int number, const Target& target);
  Step run_level(int number, const Target& target);
  bool torn() const;
  bool has_broken(const Target& target, int evaluations) const;
  double balance(double multiplier);
  void end_reached(const Step& step);
  std::optional<ContactCheck> check_contact();

  const Problem& problem_;
  const Sheet& sheet_;         ///< this rank's part of a shared one
  const SharedSheet* shared_;  ///< nothing: the sheet is whole
  ForceField& force_field_;
  const PathCallbacks& callbacks_;
  std::unique_ptr<LoadTerm> load_;
  Eigen::VectorXd rim_pull_;  ///< dead forces on the free atoms, eV/Å
  Preconditioner preconditioner_;
  Eigen::VectorXd reference_;  ///< the flat sheet in equilibrium
  Eigen::VectorXd positions_, atom_forces_, factorised_at_;
  std::vector<PathState> states_;
  BreakSearch break_;
  std::vector<std::pair<double, double>> curve_;  ///< (depth, force) of the same states
  double flat_energy_ = 0;
  int loaded_levels_ = 0;              ///< reached while loading
  std::optional<int> unloading_from_;  ///< level index that unloading goes to next, plus one
  int factorisations_ = 0, first_evaluations_ = 0;
  double factor_parameter_ = 0;  ///< path parameter that the factor was made for
  bool factor_is_tired_ = true;  ///< no factor yet
  bool fresh_ = true;
  Report report_;
};

}  // namespace atomistic
