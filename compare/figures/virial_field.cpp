#include "compare/figures/virial_field.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <stdexcept>

namespace validate {
namespace {

struct Sum {
  Eigen::Matrix3d virial = Eigen::Matrix3d::Zero();
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  int atoms = 0, with_area = 0;

  void add(const Eigen::VectorXd& virials, int atom, const Eigen::Vector3d& its_area) {
    const auto v = virials.segment<6>(6 * atom);
    Eigen::Matrix3d m;
    m << v[0], v[3], v[4], v[3], v[1], v[5], v[4], v[5], v[2];
    virial += m;
    area += its_area;
    ++atoms;
    with_area += its_area.squaredNorm() > 0;
  }
};

/// Principal values in the plane with this normal, larger first.
Eigen::Vector2d in_plane(const Eigen::Matrix3d& force, const Eigen::Vector3d& normal) {
  const Eigen::Vector3d one = normal.unitOrthogonal(), two = normal.cross(one);
  Eigen::Matrix<double, 3, 2> basis;
  basis << one, two;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(basis.transpose() * force * basis);
  return solver.eigenvalues().reverse();
}

}  // namespace

Eigen::Vector3d area_of_atom(const atomistic::Sheet& sheet, const Eigen::VectorXd& positions, int atom) {
  const auto& [a, b, c] = sheet.neighbours[static_cast<std::size_t>(atom)];
  if (a < 0 || b < 0 || c < 0) return Eigen::Vector3d::Zero();
  const auto half_normal = [&](const Eigen::VectorXd& x) -> Eigen::Vector3d {
    const Eigen::Vector3d at = x.segment<3>(3 * a);
    return 0.5 * (Eigen::Vector3d(x.segment<3>(3 * b)) - at).cross(Eigen::Vector3d(x.segment<3>(3 * c)) - at);
  };
  return half_normal(positions) * (half_normal(sheet.positions).z() > 0 ? 1 : -1);
}

std::vector<VirialCell> virial_field(const atomistic::Sheet& sheet, const atomistic::Step& step, int cells,
                                     int fewest) {
  if (step.virials.size() != 2 * step.positions.size())
    throw std::invalid_argument("virial field: the step has no virials");
  const double size = 2 * sheet.radius_A / cells;
  std::vector<Sum> sums(static_cast<std::size_t>(cells * cells));
  const auto index = [&](double x) { return std::clamp(static_cast<int>((x + sheet.radius_A) / size), 0, cells - 1); };
  for (int i = 0; i < sheet.free_atoms; ++i) {
    const Eigen::Vector2d place = sheet.position(i).head<2>();
    sums[static_cast<std::size_t>(index(place.y()) * cells + index(place.x()))].add(
        step.virials, i, area_of_atom(sheet, step.positions, i));
  }
  std::vector<VirialCell> field;
  for (int row = 0; row < cells; ++row)
    for (int column = 0; column < cells; ++column) {
      const Sum& sum = sums[static_cast<std::size_t>(row * cells + column)];
      if (sum.atoms < fewest || sum.with_area == 0) continue;
      const double area = sum.area.norm() * sum.atoms / sum.with_area;  // atoms on the edge have the others' area
      const Eigen::Vector2d principal = in_plane(sum.virial / area, sum.area.normalized());
      const Eigen::Vector2d low(column * size - sheet.radius_A, row * size - sheet.radius_A), x(size, 0), y(0, size);
      field.push_back({{low, low + x, low + x + y, low + y}, low + (x + y) / 2, principal[0], principal[1], sum.atoms});
    }
  return field;
}

}  // namespace validate
