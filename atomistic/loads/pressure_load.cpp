#include "atomistic/loads/pressure_load.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace atomistic {

using Eigen::Vector3d;
using Eigen::VectorXd;

PressureTerm::PressureTerm(const PressureLoad& load, const Problem& problem, const Sheet& sheet)
    : problem_(problem), sheet_(sheet), following_(load.following), rings_(rings(sheet)) {
  if (problem.control != Control::force)
    throw std::invalid_argument("pressure: its levels are pressures; a depth cannot be controlled");
  const VectorXd flat = sheet.positions.head(3 * sheet.free_atoms);
  volume(flat, flat_share_);
  for (const auto& ring : rings_)
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Vector3d p = sheet.position(ring[k]), q = sheet.position(ring[(k + 1) % ring.size()]);
      area_ += p.cross(q).z() / 2;
    }
}

/// Six times the volume of the cone from the origin over a triangle is p·(q × r).
double PressureTerm::volume(const VectorXd& x, VectorXd& gradient) const {
  const auto place = [&](int atom) -> Vector3d {
    return atom < sheet_.free_atoms ? Vector3d(x.segment<3>(3 * atom)) : Vector3d(sheet_.position(atom));
  };
  gradient.setZero(x.size());
  const auto add = [&](int atom, const Vector3d& g) {
    if (atom < sheet_.free_atoms) gradient.segment<3>(3 * atom) -= g / 6;
  };
  double six_volumes = 0;
  for (const auto& ring : rings_) {
    const double n = static_cast<double>(ring.size());
    Vector3d middle = Vector3d::Zero(), at_middle = Vector3d::Zero();
    for (int atom : ring) middle += place(atom) / n;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const int i = ring[k], j = ring[(k + 1) % ring.size()];
      const Vector3d p = place(i), q = place(j);
      six_volumes += middle.dot(p.cross(q));
      at_middle += p.cross(q);
      add(i, q.cross(middle));
      add(j, middle.cross(p));
    }
    for (int atom : ring) add(atom, at_middle / n);
  }
  return -six_volumes / 6;
}

double PressureTerm::conjugate_depth(const VectorXd& x) {
  VectorXd unused;
  return (following_ ? volume(x, unused) : flat_share_.dot(x)) / area_;
}

double PressureTerm::add(const VectorXd& x, VectorXd& gradient) {
  if (!following_) {
    gradient -= pressure_ * flat_share_;
    return -pressure_ * flat_share_.dot(x);
  }
  VectorXd share;
  const double v = volume(x, share);
  gradient -= pressure_ * share;
  return -pressure_ * v;
}

double PressureTerm::parameter(double pressure) const { return std::cbrt(pressure); }

/// Hencky's clamped membrane, w0 = 0.66 R (pR/E·h)^{1/3}, with a parabola for its shape (a square's: the
/// product of two).
VectorXd PressureTerm::first_guess() const {
  const double r = sheet_.radius_A,
               depth = 0.66 * r * std::cbrt(pressure_ * r / problem_.card.sheet_modulus_eV_per_A2());
  VectorXd u = VectorXd::Zero(3 * sheet_.free_atoms);
  for (int i = 0; i < sheet_.free_atoms; ++i) {
    const Eigen::Vector2d s = (sheet_.position(i).head<2>() / r).array().square();
    const double shape = sheet_.form.shape == Shape::disc ? 1 - s.sum() : (1 - s.x()) * (1 - s.y());
    u[3 * i + 2] = -depth * std::max(shape, 0.0);
  }
  return u;
}

}  // namespace atomistic
