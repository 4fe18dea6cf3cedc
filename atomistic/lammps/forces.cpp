#include "atomistic/lammps/forces.hpp"

#include <algorithm>
#include <stdexcept>

namespace atomistic {
namespace {

/// Holds every state, with room to spare.
Box box_around(const std::vector<Eigen::VectorXd>& positions) {
  constexpr double room_A = 10;
  double farthest = 0;
  for (const Eigen::VectorXd& x : positions) farthest = std::max(farthest, x.cwiseAbs().maxCoeff());
  const Eigen::Vector3d corner = Eigen::Vector3d::Constant(farthest + room_A);
  return {.low = -corner, .high = corner};
}

}  // namespace

std::vector<AtomForces> compute_forces(const Potential& potential, const std::vector<Eigen::VectorXd>& positions,
                                       const std::string& log_file, const MpiSession& session) {
  if (positions.empty()) throw std::invalid_argument("forces: no positions");
  for (const Eigen::VectorXd& x : positions)
    if (x.size() != positions[0].size() || x.size() == 0 || x.size() % 3 != 0)
      throw std::invalid_argument("forces: positions are 3N numbers, all of one size");
  ForceField field(potential, box_around(positions), positions[0], log_file);
  std::vector<AtomForces> states;
  if (session.rank() != 0) {
    field.serve();
    return states;
  }
  for (const Eigen::VectorXd& x : positions) {
    AtomForces& at = states.emplace_back();
    at.energy_eV = field.evaluate(x, at.forces_eV_per_A);
  }
  return states;
}

}  // namespace atomistic
