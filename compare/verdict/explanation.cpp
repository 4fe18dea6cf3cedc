#include "compare/verdict/explanation.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "compare/fitting/curve.hpp"

namespace validate {

double Anisotropy::at(double depth) const {
  if (ratio.empty()) return not_known;
  const auto above = std::ranges::lower_bound(conjugate_depth_A, depth) - conjugate_depth_A.begin();
  const auto i = static_cast<std::size_t>(above);
  if (i == 0) return ratio.front();
  if (i >= ratio.size()) return ratio.back();
  const double share = (depth - conjugate_depth_A[i - 1]) / (conjugate_depth_A[i] - conjugate_depth_A[i - 1]);
  return std::lerp(ratio[i - 1], ratio[i], share);
}

std::optional<Explanation> explain(const Run& atoms, const Stages& stages, const Anisotropy& anisotropy) {
  std::vector<std::unique_ptr<Curve>> curves;
  for (const Run* stage : stages) {
    if (usable_points(*stage).size() < 2) return std::nullopt;
    curves.push_back(std::make_unique<Curve>(*stage));
  }
  std::vector<std::size_t> points = usable_points(atoms);
  std::ranges::sort(points, {}, [&](std::size_t i) { return atoms.depth_A[i]; });

  Explanation found;
  found.load = atoms.load;
  for (const std::size_t i : points) {
    std::array<double, std::tuple_size_v<Stages>> force{};
    bool covered = true;
    for (std::size_t k = 0; k < curves.size(); ++k) {
      const auto at = curves[k]->at(atoms.depth_A[i]);
      covered = covered && at;
      force[k] = at.value_or(not_known);
    }
    if (!covered) continue;
    const double plain = force[0];
    found.depth_A.push_back(atoms.depth_A[i]);
    found.depth_relative.push_back(atoms.depth_A[i] / atoms.a_A);
    found.plain_force_eV_per_A.push_back(plain);
    found.geometry.push_back((force[1] - force[0]) / plain);
    found.bending.push_back((force[2] - force[1]) / plain);
    found.large_strain.push_back((force[3] - force[2]) / plain);
    const double directions = force[3] * (anisotropy.at(atoms.conjugate_depth_A[i]) - 1);
    found.anisotropy.push_back(directions / plain);
    const double known = std::isfinite(directions) ? directions : 0;
    found.remainder.push_back((atoms.force_eV_per_A[i] - force[3] - known) / plain);
  }
  if (found.depth_A.empty()) return std::nullopt;
  return found;
}

}  // namespace validate
