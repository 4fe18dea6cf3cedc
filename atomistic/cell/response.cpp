#include "atomistic/cell/response.hpp"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "atomistic/cell/homogeneous_cell.hpp"

namespace atomistic {
namespace {

using Eigen::Matrix2d;

constexpr double strain_step = 0.01, largest_strain = 0.6;
constexpr double fallen = 0.95;          ///< of the largest stress: the curve ends
constexpr double ruptured_bond_A = 2.2;  ///< beyond every bundled potential's reach

/// One point of a curve.
struct Point {
  double lateral_stretch, stress, longest_bond;
  bool good;
};

/// Nominal stress F S along the given axis (0: zigzag, 1: armchair) and across, at two principal stretches along the
/// sheet's axes.
struct Stresses {
  double along, across, longest_bond;
  bool good;
};

Stresses stresses(HomogeneousCell& cell, int axis, double along, double across) {
  Matrix2d f = Matrix2d::Zero();
  f(axis, axis) = along;
  f(1 - axis, 1 - axis) = across;
  const Matrix2d s = pulled_back(f, cell.relaxed(f, true));
  return {along * s(axis, axis), across * s(1 - axis, 1 - axis), cell.longest_bond(f), cell.in_balance()};
}

/// The lateral stretch that leaves no lateral stress, by the secant method from the last one.
Point uniaxial(HomogeneousCell& cell, const Card& card, int axis, double stretch, double lateral) {
  const double modulus = card.C11_eV_per_A2;
  double previous = lateral, previous_stress = stresses(cell, axis, stretch, previous).across;
  double next = previous - previous_stress / modulus;
  Stresses at{};
  for (int i = 0; i < 30; ++i) {
    at = stresses(cell, axis, stretch, next);
    if (std::abs(at.across) < 1e-9 * modulus) break;
    double slope = (at.across - previous_stress) / (next - previous);
    if (!(slope > 0.02 * modulus)) slope = modulus;
    previous = next;
    previous_stress = at.across;
    next -= std::clamp(at.across / slope, -0.02, 0.02);
  }
  return {next, at.along, at.longest_bond, at.good && std::abs(at.across) < 1e-6 * modulus};
}

Point equibiaxial(HomogeneousCell& cell, const Card&, int, double stretch, double) {
  const Stresses at = stresses(cell, 0, stretch, stretch);
  return {stretch, at.along, at.longest_bond, at.good};
}

using Follow = Point (*)(HomogeneousCell&, const Card&, int axis, double stretch, double lateral);

/// Where a value is reached, linearly between the points.
std::optional<double> crossing(const std::vector<double>& x, const std::vector<double>& y, double value) {
  for (std::size_t k = 1; k < y.size(); ++k)
    if (y[k] >= value) return std::lerp(x[k - 1], x[k], (value - y[k - 1]) / (y[k] - y[k - 1]));
  return std::nullopt;
}

/// The maximum of the parabola through the largest point and its neighbours.
void find_strength(StressCurve& curve) {
  const auto& s = curve.stress_eV_per_A2;
  const auto k = static_cast<std::size_t>(std::max_element(s.begin(), s.end()) - s.begin());
  curve.strength_eV_per_A2 = s[k];
  curve.strain_at_strength = curve.strain[k];
  if (k == 0 || k + 1 == s.size()) return;
  const double slope = (s[k + 1] - s[k - 1]) / 2, bend = s[k + 1] - 2 * s[k] + s[k - 1];
  if (!(bend < 0)) return;
  curve.strength_eV_per_A2 -= slope * slope / (2 * bend);
  curve.strain_at_strength -= strain_step * slope / bend;
}

StressCurve stress_curve(HomogeneousCell& cell, const Potential& potential, const Card& card,
                         const std::string& direction, Follow follow, int axis) {
  StressCurve curve{.direction = direction,
                    .strain = {0},
                    .lateral_strain = {0},
                    .stress_eV_per_A2 = {0},
                    .longest_bond_A = {card.bond_A()}};
  cell.relaxed(Matrix2d::Identity());
  double lateral = 1, largest = 0;
  for (int k = 1; k * strain_step < largest_strain + 1e-9; ++k) {
    const Point at = follow(cell, card, axis, 1 + k * strain_step, lateral);
    if (!at.good || at.longest_bond > ruptured_bond_A || at.stress < fallen * largest) break;
    lateral = at.lateral_stretch;
    largest = std::max(largest, at.stress);
    curve.strain.push_back(k * strain_step);
    curve.lateral_strain.push_back(lateral - 1);
    curve.stress_eV_per_A2.push_back(at.stress);
    curve.longest_bond_A.push_back(at.longest_bond);
  }
  const auto secant = [&](std::size_t k) {
    return k < curve.strain.size() ? curve.stress_eV_per_A2[k] / curve.strain[k] : std::nan("");
  };
  curve.secant_2_eV_per_A2 = secant(2);
  curve.secant_5_eV_per_A2 = secant(5);
  curve.secant_10_eV_per_A2 = secant(10);
  find_strength(curve);
  curve.artefact_strain = crossing(curve.strain, curve.longest_bond_A, potential.artefact_bond_A);
  return curve;
}

Matrix2d rotation(double degrees) { return Eigen::Rotation2Dd(degrees * std::numbers::pi / 180).toRotationMatrix(); }

HomogeneousState state_at(HomogeneousCell& cell, const StrainState& strain, double flat_energy, double atoms_per_area) {
  const Matrix2d turn = rotation(strain.orientation_deg);
  const Matrix2d given{{strain.E11, strain.E12}, {strain.E12, strain.E22}};
  const Matrix2d own = turn * given * turn.transpose();
  if (!((Matrix2d::Identity() + 2 * own).determinant() > 0 && 1 + 2 * own(0, 0) > 0))
    throw std::invalid_argument("state: this strain has no deformation");
  const Matrix2d f = gradient_of_strain(own);
  const Matrix2d s = turn.transpose() * pulled_back(f, cell.relaxed(f)) * turn;
  const bool settled = cell.in_balance() && cell.stable(f);
  return {.strain = strain,
          .S11_eV_per_A2 = s(0, 0),
          .S22_eV_per_A2 = s(1, 1),
          .S12_eV_per_A2 = s(0, 1),
          .energy_eV_per_A2 = (cell.energy_per_atom() - flat_energy) * atoms_per_area,
          .longest_bond_A = cell.longest_bond(f),
          .shift_x_A = cell.shift().x(),
          .shift_y_A = cell.shift().y(),
          .converged = settled};
}

}  // namespace

Response compute_response(const Potential& potential, const Card& card, const std::vector<StrainState>& strains,
                          const std::string& log_file) {
  HomogeneousCell cell(potential, {3, 2, card.a0_A}, log_file);
  cell.affine(Matrix2d::Identity());
  const double flat_energy = cell.energy_per_atom();
  Response response;
  for (const StrainState& strain : strains)
    response.states.push_back(state_at(cell, strain, flat_energy, 1 / card.area_per_atom_A2()));
  response.curves.push_back(stress_curve(cell, potential, card, "zigzag", uniaxial, 0));
  response.curves.push_back(stress_curve(cell, potential, card, "armchair", uniaxial, 1));
  response.curves.push_back(stress_curve(cell, potential, card, "equibiaxial", equibiaxial, 0));
  return response;
}

}  // namespace atomistic
