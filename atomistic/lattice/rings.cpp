// The faces of the flat sheet's graph, walked bond by bond.
#include <algorithm>
#include <cmath>
#include <utility>

#include "atomistic/lattice/sheet.hpp"

namespace atomistic {
namespace {

/// Neighbours of each atom in counter-clockwise order.
std::vector<std::vector<int>> turned_neighbours(const Sheet& sheet) {
  std::vector<std::vector<int>> all(sheet.neighbours.size());
  for (int i = 0; i < sheet.atoms(); ++i) {
    for (int n : sheet.neighbours[i])
      if (n >= 0) all[i].push_back(n);
    const auto angle = [&](int n) {
      const Eigen::Vector3d d = sheet.position(n) - sheet.position(i);
      return std::atan2(d.y(), d.x());
    };
    std::sort(all[i].begin(), all[i].end(), [&](int p, int q) { return angle(p) < angle(q); });
  }
  return all;
}

double signed_area(const Sheet& sheet, const std::vector<int>& loop) {
  double twice = 0;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const auto p = sheet.position(loop[k]), q = sheet.position(loop[(k + 1) % loop.size()]);
    twice += p.x() * q.y() - p.y() * q.x();
  }
  return twice / 2;
}

}  // namespace

std::vector<std::vector<int>> rings(const Sheet& sheet) {
  const auto neighbours = turned_neighbours(sheet);
  std::vector<std::array<bool, 3>> walked(neighbours.size());  // directed bonds, by their place at the start
  const auto slot = [&](int from, int to) {
    return std::find(neighbours[from].begin(), neighbours[from].end(), to) - neighbours[from].begin();
  };
  std::vector<std::vector<int>> found;
  for (int i = 0; i < sheet.atoms(); ++i)
    for (std::size_t first = 0; first < neighbours[i].size(); ++first) {
      if (walked[i][first]) continue;
      std::vector<int> loop;
      int from = i, to = neighbours[i][first];
      for (auto s = first; !walked[from][s]; s = static_cast<std::size_t>(slot(from, to))) {
        walked[from][s] = true;
        loop.push_back(from);
        const auto& around = neighbours[to];  // the next bond clockwise keeps the ring on the left
        const auto back = static_cast<std::size_t>(slot(to, from));
        from = std::exchange(to, around[(back + around.size() - 1) % around.size()]);
      }
      const bool has_free = std::any_of(loop.begin(), loop.end(), [&](int atom) { return atom < sheet.free_atoms; });
      if (has_free && loop.size() >= 3 && signed_area(sheet, loop) > 0) found.push_back(std::move(loop));
    }
  return found;
}

}  // namespace atomistic
