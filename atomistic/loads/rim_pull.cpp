#include "atomistic/loads/rim_pull.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace atomistic {
namespace {

/// The atoms that slide, by their angle.
std::vector<int> around(const Sheet& sheet) {
  std::vector<int> atoms;
  for (std::size_t i = 0; i < sheet.slides.size(); ++i)
    if (sheet.slides[i]) atoms.push_back(static_cast<int>(i));
  if (atoms.size() < 3) throw std::invalid_argument("rim tension: needs a rim that slides");
  const auto angle = [&](int i) { return std::atan2(sheet.position(i).y(), sheet.position(i).x()); };
  std::ranges::sort(atoms, {}, angle);
  return atoms;
}

/// Counter-clockwise from one atom to another, in [0, 2π).
double angle_between(const Sheet& sheet, int from, int to) {
  const Eigen::Vector2d a = sheet.position(from).head<2>(), b = sheet.position(to).head<2>();
  const double angle = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

}  // namespace

double rim_radius_A(const Sheet& sheet) {
  double sum = 0;
  const std::vector<int> atoms = around(sheet);
  for (const int i : atoms) sum += sheet.position(i).head<2>().norm();
  return sum / static_cast<double>(atoms.size());
}

Eigen::VectorXd rim_pull(const Sheet& sheet, double tension_eV_per_A2) {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(sheet.free_atoms));
  if (tension_eV_per_A2 == 0) return forces;
  const std::vector<int> atoms = around(sheet);
  const double radius = rim_radius_A(sheet);
  for (std::size_t k = 0; k < atoms.size(); ++k) {
    const int before = atoms[(k + atoms.size() - 1) % atoms.size()], next = atoms[(k + 1) % atoms.size()];
    const double share = (angle_between(sheet, before, atoms[k]) + angle_between(sheet, atoms[k], next)) / 2;
    forces.segment<2>(3 * atoms[k]) =
        tension_eV_per_A2 * radius * share * sheet.position(atoms[k]).head<2>().normalized();
  }
  return forces;
}

double rim_displacement_A(const Sheet& sheet, const Eigen::VectorXd& positions) {
  double sum = 0;
  const std::vector<int> atoms = around(sheet);
  for (const int i : atoms) {
    const Eigen::Vector2d place = sheet.position(i).head<2>();
    sum += (positions.segment<2>(3 * i) - place).dot(place.normalized());
  }
  return sum / static_cast<double>(atoms.size());
}

}  // namespace atomistic
