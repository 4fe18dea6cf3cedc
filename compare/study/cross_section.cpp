#include "compare/study/cross_section.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace validate {
namespace {

CrossSection sorted(const CrossSection& profile) {
  std::vector<std::size_t> order(profile.x_A.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return profile.x_A[i]; });
  CrossSection result;
  for (const std::size_t i : order) {
    result.x_A.push_back(profile.x_A[i]);
    result.z_A.push_back(profile.z_A[i]);
  }
  return result;
}

}  // namespace

CrossSection cross_section(const atomistic::Sheet& sheet, const Eigen::VectorXd& positions) {
  constexpr double half_width_bonds = 0.6;
  CrossSection profile;
  for (int i = 0; i < sheet.free_atoms; ++i) {
    if (std::abs(sheet.position(i).y()) > half_width_bonds * sheet.bond_A) continue;
    profile.x_A.push_back(positions[3 * i]);
    profile.z_A.push_back(positions[3 * i + 2]);
  }
  return sorted(profile);
}

CrossSection cross_section(const SheetPicture& picture) {
  const membrane::Mesh& mesh = picture.mesh;
  CrossSection profile;
  double size = 0;
  for (const Eigen::Vector2d& node : mesh.nodes) size = std::max(size, node.norm());
  for (int n = 0; n < mesh.node_count(); ++n) {
    if (std::abs(mesh.nodes[static_cast<std::size_t>(n)].y()) > 1e-9 * size) continue;
    const double x =
        mesh.nodes[static_cast<std::size_t>(n)].x() + picture.displacement[3 * static_cast<std::size_t>(n)];
    const double z = picture.displacement[3 * static_cast<std::size_t>(n) + 2];
    for (const double side : {1.0, -1.0}) {
      if (side < 0 && (mesh.copies == 1 || x < 1e-9 * size)) continue;
      profile.x_A.push_back(side * x);
      profile.z_A.push_back(z);
    }
  }
  return sorted(profile);
}

}  // namespace validate
