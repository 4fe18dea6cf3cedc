// What the groups that verify atoms and calibration may ask of the atomistic program.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "atomistic/response.hpp"
#include "compare/base/progress.hpp"
#include "compare/base/temporary_folder.hpp"
#include "compare/potential/potential_card.hpp"
#include "compare/process/atoms.hpp"

namespace validate::verify {

/// Everything it hands out comes from validate-atoms, as in a user's run. Each of them throws Error where that fails.
class Laboratory {
 public:
  struct Means {
    AtomsLaunch launch;
    std::filesystem::path potentials, cards;  ///< folder of descriptions; cache of cards, empty: none
    std::vector<std::string> chosen;          ///< names or paths of the potentials to verify
  };
  explicit Laboratory(Means means) : means_(std::move(means)), folder_("validate-verify") {}

  const std::vector<std::string>& potentials() const { return means_.chosen; }
  const PotentialCard& card(const std::string& potential);

  /// Energy and forces of isolated atoms at each of the positions, 3N.
  std::vector<atomistic::AtomForces> forces(const std::string& potential, std::vector<Eigen::VectorXd> positions);

  /// The relaxed lattice under each strain.
  std::vector<atomistic::HomogeneousState> states(const std::string& potential,
                                                  std::vector<atomistic::StrainState> strains);

  /// A path's steps, on this many ranks; positions and forces of the last alone.
  std::vector<atomistic::Step> path(const atomistic::Problem& problem, int ranks);

  /// A path on the potential's own lattice.
  atomistic::Problem problem(const std::string& potential, double radius_A, const atomistic::Load& load,
                             std::vector<double> levels);

 private:
  std::string next_name() { return "job" + std::to_string(++jobs_); }
  atomistic::Event last_event(const std::string& name, decltype(atomistic::Job::work) work);

  Means means_;
  TemporaryFolder folder_;
  std::map<std::string, PotentialCard> cards_;
  Progress quiet_{true};
  int jobs_ = 0;
};

}  // namespace validate::verify
