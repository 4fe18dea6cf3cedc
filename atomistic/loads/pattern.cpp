#include "atomistic/loads/pattern.hpp"

#include <algorithm>
#include <stdexcept>

namespace atomistic {
namespace {

struct LoadedAtoms {
  const Sheet& sheet;
  std::vector<int> operator()(const PointLoad&) const { return {sheet.hexagon.begin(), sheet.hexagon.end()}; }
  std::vector<int> operator()(const DiscLoad& disc) const { return atoms_within(sheet, disc.radius_A); }
};

}  // namespace

std::vector<int> loaded_atoms(const Load& load, const Sheet& sheet) {
  return std::visit(LoadedAtoms{sheet}, load);
}

LoadPattern::LoadPattern(const Load& load, const Sheet& sheet) : atoms_(loaded_atoms(load, sheet)) {
  if (atoms_.empty() || *std::max_element(atoms_.begin(), atoms_.end()) >= sheet.free_atoms)
    throw std::invalid_argument("load: it must hold at least one atom and none of the clamped ones");
  direction_.setZero(3 * sheet.free_atoms);
  for (int atom : atoms_) direction_[3 * atom + 2] = 1.0 / static_cast<double>(atoms_.size());
}

}  // namespace atomistic
