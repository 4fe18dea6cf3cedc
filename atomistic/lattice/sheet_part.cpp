#include "atomistic/lattice/sheet_part.hpp"

#include <algorithm>
#include <map>

namespace atomistic {
namespace {

/// Atoms that are not among `inside`, which is sorted, but bonded to one of them: sorted.
std::vector<int> around(const Sheet& whole, const std::vector<int>& inside) {
  std::vector<int> found;
  for (const int atom : inside)
    for (const int n : whole.neighbours[atom])
      if (n >= 0 && !std::ranges::binary_search(inside, n)) found.push_back(n);
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::vector<int> with_two_bonds(const Sheet& whole, const std::vector<int>& own) {
  std::vector<int> inside = own;
  for (int bonds = 0; bonds < 2; ++bonds) {
    const std::vector<int> more = around(whole, inside);
    inside.insert(inside.end(), more.begin(), more.end());
    std::ranges::sort(inside);
  }
  return inside;
}

/// Of each free atom: which it is among those of its owner.
std::vector<int> places(const std::vector<int>& owner) {
  std::vector<int> place, counts;
  for (const int rank : owner) {
    if (rank >= static_cast<int>(counts.size())) counts.resize(static_cast<std::size_t>(rank) + 1, 0);
    place.push_back(counts[rank]++);
  }
  return place;
}

std::vector<int> own_of(const std::vector<int>& atoms, const SheetPart& part) {
  std::vector<int> own;
  const auto end = part.ids.begin() + part.sheet.free_atoms;
  for (const int atom : atoms) {
    const auto at = std::lower_bound(part.ids.begin(), end, atom);
    if (at != end && *at == atom) own.push_back(static_cast<int>(at - part.ids.begin()));
  }
  return own;
}

/// The atoms in their order, and how many are own and of others.
void choose_atoms(const Sheet& whole, const std::vector<int>& owner, int rank, SheetPart& part) {
  std::vector<int> own, ghosts, clamped;
  for (int k = 0; k < whole.free_atoms; ++k)
    if (owner[k] == rank) own.push_back(k);
  const std::vector<int> place = places(owner);
  for (const int atom : with_two_bonds(whole, own)) {
    if (atom >= whole.free_atoms) clamped.push_back(atom);
    if (atom >= whole.free_atoms || owner[atom] == rank) continue;
    ghosts.push_back(atom);
    part.owner.push_back(owner[atom]);
    part.place.push_back(place[atom]);
  }
  part.sheet.free_atoms = static_cast<int>(own.size());
  part.ghosts = static_cast<int>(ghosts.size());
  for (const auto* group : {&own, &ghosts, &clamped}) part.ids.insert(part.ids.end(), group->begin(), group->end());
}

/// Each bond of an own atom once.
void connect(const Sheet& whole, SheetPart& part) {
  std::map<int, int> beyond;  // the own atoms are found by their order
  const auto own_end = part.ids.begin() + part.sheet.free_atoms;
  for (std::size_t k = static_cast<std::size_t>(part.sheet.free_atoms); k < part.ids.size(); ++k)
    beyond[part.ids[k]] = static_cast<int>(k);
  const auto local = [&](int atom) {
    const auto at = std::lower_bound(part.ids.begin(), own_end, atom);
    if (at != own_end && *at == atom) return static_cast<int>(at - part.ids.begin());
    const auto other = beyond.find(atom);
    return other == beyond.end() ? -1 : other->second;
  };
  for (std::size_t k = 0; k < part.ids.size(); ++k) {
    auto& neighbours = part.sheet.neighbours.emplace_back(whole.neighbours[part.ids[k]]);
    for (int& n : neighbours) n = n < 0 ? -1 : local(n);
    const int i = static_cast<int>(k);
    for (const int n : neighbours)
      if (i < part.sheet.free_atoms && i < n) part.sheet.bonds.push_back({i, n});
  }
}

}  // namespace

Eigen::VectorXd part_of(const Eigen::VectorXd& whole, const SheetPart& part) {
  Eigen::VectorXd numbers(3 * static_cast<Eigen::Index>(part.ids.size()));
  for (std::size_t k = 0; k < part.ids.size(); ++k)
    numbers.segment<3>(3 * static_cast<Eigen::Index>(k)) = whole.segment<3>(3 * static_cast<Eigen::Index>(part.ids[k]));
  return numbers;
}

SheetPart part_of(const Sheet& whole, const std::vector<int>& owner, int rank) {
  SheetPart part;
  part.sheet.bond_A = whole.bond_A;
  part.sheet.radius_A = whole.radius_A;
  part.sheet.form = whole.form;
  choose_atoms(whole, owner, rank, part);
  part.sheet.positions = part_of(whole.positions, part);
  connect(whole, part);
  part.sheet.innermost = own_of(whole.innermost, part);
  part.sheet.record = own_of(whole.record, part);
  return part;
}

}  // namespace atomistic
