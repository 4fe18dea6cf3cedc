#include "atomistic/equilibrium/shared_sheet.hpp"

#include <stdexcept>

namespace atomistic {
namespace {

std::vector<Place> ghost_places(const SheetPart& part) {
  std::vector<Place> places;
  for (std::size_t k = 0; k < part.owner.size(); ++k) places.push_back({part.owner[k], part.place[k]});
  return places;
}

}  // namespace

SharedSheet::SharedSheet(const Sheet& whole, ForceField& forces)
    : forces_(forces),
      flat_(team_.rank() == 0 ? whole.positions : Eigen::VectorXd()),
      part_(part_of(whole, team_.owners(forces.atoms_here(), whole.free_atoms), team_.rank())),
      own_(part_.ids.begin(), part_.ids.begin() + part_.sheet.free_atoms),
      halo_(ghost_places(part_)) {
  if (team_.least(part_.sheet.free_atoms) == 0)
    throw std::runtime_error("there are more ranks than the sheet has room for: one of them has no free atom");
  forces.share_out(own_);
}

void SharedSheet::refresh(Eigen::VectorXd& positions) const {
  const Eigen::Index own = 3 * static_cast<Eigen::Index>(own_.size());
  positions.segment(own, 3 * static_cast<Eigen::Index>(part_.ghosts)) = halo_.fetch(positions.head(own));
}

/// Of the part's free atoms, in the matrix of all: rank after rank, each in the order of its own.
std::vector<int> SharedSheet::numbers() const {
  const std::vector<int> starts = team_.starts(part_.sheet.free_atoms);
  std::vector<int> numbers;
  for (int k = 0; k < part_.sheet.free_atoms; ++k) numbers.push_back(starts[team_.rank()] + k);
  for (std::size_t k = 0; k < part_.owner.size(); ++k) numbers.push_back(starts[part_.owner[k]] + part_.place[k]);
  return numbers;
}

std::unique_ptr<NetworkSolver> SharedSheet::solver(const SpringConstants& constants) const {
  return make_shared_solver(part_, constants, numbers());
}

Step SharedSheet::part_of_step(const Step& whole) const {
  Step step = whole;
  for (Eigen::VectorXd* v : {&step.positions, &step.factorised_at})
    if (v->size() > 0) *v = part_of(*v, part_);
  step.forces.resize(0);
  return step;
}

Step SharedSheet::whole_step(const Step& part) const {
  Step step = part;
  const Eigen::Index own = 3 * static_cast<Eigen::Index>(own_.size());
  for (Eigen::VectorXd* v : {&step.positions, &step.factorised_at}) {
    Eigen::VectorXd whole = flat_;
    team_.gather(v->head(own), own_, whole);
    *v = std::move(whole);
  }
  step.forces = forces_.gather_forces();
  return step;
}

}  // namespace atomistic
