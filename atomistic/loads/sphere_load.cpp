#include "atomistic/loads/sphere_load.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace atomistic {

using Eigen::Vector3d;
using Eigen::VectorXd;

SphereTerm::SphereTerm(const SphereLoad& sphere, const Problem& problem, const Sheet& sheet, const Team& team)
    : sphere_(sphere), problem_(problem), sheet_(sheet), team_(team) {
  if (!(sphere.radius_A > 0 && sphere.radius_A < sheet.radius_A && sphere.stiffness_eV_per_A3 > 0))
    throw std::invalid_argument("sphere: its radius must be positive and below the sheet's, its stiffness positive");
  // Atoms come nearer to the axis as the sheet stretches: a wide margin costs nothing.
  for (int atom : atoms_within(sheet, 1.2 * sphere.radius_A + 5))
    if (atom < sheet.free_atoms) candidates_.push_back(atom);
}

/// visit(atom, penetration, n): n points from the sphere's centre to the atom.
template <class Visit>
void SphereTerm::visit_contacts(const VectorXd& x, double travel, Visit&& visit) const {
  const Vector3d c = centre(travel);
  for (int atom : candidates_) {
    const Vector3d d = x.segment<3>(3 * atom) - c;
    const double r = d.norm();
    if (r < sphere_.radius_A) visit(atom, sphere_.radius_A - r, Vector3d(d / r));
  }
}

SphereTerm::Contact SphereTerm::contact_at(const VectorXd& x, double travel) const {
  Contact sum;
  const double k = sphere_.stiffness_eV_per_A3;
  visit_contacts(x, travel, [&](int, double inside, const Vector3d& n) {
    sum.energy += k * inside * inside * inside / 3;
    sum.force -= k * inside * inside * n.z();
    sum.stiffness +=
        2 * k * inside * n.z() * n.z() - k * inside * inside * (1 - n.z() * n.z()) / (sphere_.radius_A - inside);
    sum.deepest = std::max(sum.deepest, inside);
  });
  for (double* part : {&sum.energy, &sum.force, &sum.stiffness}) *part = team_.sum(*part);
  sum.deepest = team_.largest(sum.deepest);
  return sum;
}

/// Newton's method on force(d) = level inside a bracket; the force grows with the travel.
double SphereTerm::travel(const VectorXd& x) const {
  if (!held_force()) return level_;
  double low = INFINITY;  // the sphere touches nothing, or just begins to
  for (int atom : candidates_) {
    const Vector3d p = x.segment<3>(3 * atom);
    const double across = p.head<2>().squaredNorm(), r = sphere_.radius_A;
    if (across < r * r) low = std::min(low, r - std::sqrt(r * r - across) - p.z());
  }
  low = team_.least(low);
  double high = low;
  for (double more = 0.01; contact_at(x, high).force < level_; more *= 2) high = low + more;
  double d = high;
  for (int i = 0; i < 100; ++i) {
    const Contact contact = contact_at(x, d);
    (contact.force < level_ ? low : high) = d;
    const double newton = d - (contact.force - level_) / contact.stiffness;
    const double next = newton > low && newton < high ? newton : (low + high) / 2;
    if (std::abs(next - d) < 1e-14 * std::max(1.0, std::abs(d))) break;
    d = next;
  }
  return d;
}

double SphereTerm::add(const VectorXd& x, VectorXd& gradient) {
  const double d = travel(x);
  visit_contacts(x, d, [&](int atom, double inside, const Vector3d& n) {
    gradient.segment<3>(3 * atom) -= sphere_.stiffness_eV_per_A3 * inside * inside * n;
  });
  return contact_at(x, d).energy + (held_force() ? -level_ * d : 0.0);
}

double SphereTerm::parameter(double level) const { return held_force() ? std::cbrt(level) : level; }

VectorXd SphereTerm::first_guess() const {
  return schwerin_shape(sheet_, held_force() ? rough_depth(problem_, level_) : level_);
}

/// An atom far inside the sphere would be thrown out with a force like its penetration squared: no prediction
/// starts with more than what carries a sixth of the force, at most 0.1 eV/Å.
void SphereTerm::admit(VectorXd& x) {
  const double force = held_force() ? level_ : rough_force(problem_, level_);
  const double allowed = std::sqrt(std::min(0.1, force / 6) / sphere_.stiffness_eV_per_A3);
  const double d = travel(x);
  const Vector3d c = centre(d);
  visit_contacts(x, d, [&](int atom, double inside, const Vector3d& n) {
    if (inside > allowed) x.segment<3>(3 * atom) = c + (sphere_.radius_A - allowed) * n;
  });
}

/// 2 K δ n nᵀ; the negative part from the force's turning is left out.
std::vector<AtomStiffness> SphereTerm::stiffness(const VectorXd& x) {
  std::vector<AtomStiffness> all;
  visit_contacts(x, travel(x), [&](int atom, double inside, const Vector3d& n) {
    all.push_back({atom, 2 * sphere_.stiffness_eV_per_A3 * inside * n * n.transpose()});
  });
  return all;
}

/// The sphere of held force follows its atoms: the Hessian of min over d is K_xx − k kᵀ / K_dd.
VectorXd SphereTerm::given_back(const VectorXd& x) {
  if (!held_force()) return {};
  VectorXd k = VectorXd::Zero(x.size());
  double total = 0;
  visit_contacts(x, travel(x), [&](int atom, double inside, const Vector3d& n) {
    const double stiffness = 2 * sphere_.stiffness_eV_per_A3 * inside;
    k.segment<3>(3 * atom) = stiffness * n.z() * n;
    total += stiffness * n.z() * n.z();
  });
  total = team_.sum(total);
  return total > 0 ? VectorXd(k / std::sqrt(total)) : VectorXd();
}

}  // namespace atomistic
