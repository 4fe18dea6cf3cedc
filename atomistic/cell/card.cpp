#include "atomistic/cell/card.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "atomistic/cell/clamp_margins.hpp"
#include "atomistic/cell/homogeneous_cell.hpp"
#include "atomistic/lammps/lammps.hpp"

namespace atomistic {
namespace {

using Eigen::Matrix2d;
using Eigen::VectorXd;

/// a0 from the zero of the isotropic membrane force, by the secant method from graphene's 2.46 Å.
double lattice_constant(const Potential& potential, const std::string& log_file) {
  const double start = 2.46;
  HomogeneousCell cell(potential, {6, 4, start}, log_file);
  const auto tension = [&](double a) { return cell.affine(a / start * Matrix2d::Identity()).trace() / 2; };
  double a = start, previous = start * 1.002;
  double t = tension(a), t_previous = tension(previous);
  for (int i = 0; i < 40 && std::abs(a - previous) > 1e-11 * start; ++i) {
    double next = a - t * (a - previous) / (t - t_previous);
    next = std::clamp(next, a - 0.05, a + 0.05);
    previous = a;
    t_previous = t;
    a = next;
    t = tension(a);
    if (!(a > 2.0 && a < 3.0)) break;
    if (t == t_previous) return a;
  }
  if (!(a > 2.0 && a < 3.0 && std::abs(t) < 1e-7))
    throw std::runtime_error(fmt::format("no flat sheet without membrane force found near a = 2.46 Å (reached {})", a));
  return a;
}

/// dS/dE along `strain`, by central differences.
Matrix2d stiffness_along(HomogeneousCell& cell, const Matrix2d& strain) {
  constexpr double small = 5e-4;
  const auto stress = [&](double factor) {
    const Matrix2d f = gradient_of_strain(factor * strain);
    return pulled_back(f, cell.relaxed(f));
  };
  return (stress(small) - stress(-small)) / (2 * small);
}

/// Response to a small ripple: the softer eigenvalue of the two sublattices' out-of-plane stiffness at its
/// wave vector is κ q⁴ A_atom, the stiffer one their stiffness against each other.
struct Ripple {
  double bending_modulus, sublattice_stiffness;
};

/// A ripple with the given number of cells per wave.
Ripple ripple(const Potential& potential, double a, int cells, bool zigzag, const std::string& log_file) {
  constexpr double amplitude = 1e-3;
  const Supercell cell = zigzag ? Supercell{cells, 3, a} : Supercell{4, cells, a};
  const int axis = zigzag ? 0 : 1;
  const double length = zigzag ? cells * a : cells * a * std::numbers::sqrt3;
  const double q = 2 * std::numbers::pi / length;
  const VectorXd flat = cell.positions();
  ForceField forces(potential, cell.box(), flat, log_file);

  using Complex = std::complex<double>;
  const auto wave = [&](int atom) { return std::polar(1.0, q * flat[3 * atom + axis]); };
  Eigen::Matrix2cd stiffness = Eigen::Matrix2cd::Zero();
  for (int moved : {0, 1}) {
    for (const Complex phase : {Complex(1, 0), Complex(0, 1)}) {  // cosine, then sine
      VectorXd x = flat, f;
      for (int i = moved; i < cell.atoms(); i += 2) x[3 * i + 2] = amplitude * (wave(i) * std::conj(phase)).real();
      forces.evaluate(x, f, true);
      for (int i = 0; i < cell.atoms(); ++i)
        stiffness(Supercell::sublattice(i), moved) -= f[3 * i + 2] * std::conj(wave(i)) * phase;
    }
  }
  stiffness /= amplitude * cell.atoms() / 2.0;
  const Eigen::Matrix2cd hermitian = (stiffness + stiffness.adjoint()) / 2;
  const Eigen::Vector2d eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2cd>(hermitian).eigenvalues();
  return {eigenvalues[0] / (std::pow(q, 4) * cell.area() / cell.atoms()), eigenvalues[1]};
}

/// Extrapolates two wavelengths to the infinite one; the error of each falls like q².
Ripple longest_ripple(const Potential& potential, double a, bool zigzag, const std::string& log_file) {
  const int cells = zigzag ? 16 : 10;
  const Ripple shorter = ripple(potential, a, cells, zigzag, log_file);
  const Ripple longer = ripple(potential, a, 2 * cells, zigzag, log_file);
  return {(4 * longer.bending_modulus - shorter.bending_modulus) / 3,
          (4 * longer.sublattice_stiffness - shorter.sublattice_stiffness) / 3};
}

/// Under equibiaxial strain every bond carries the tension T = √3 l N(l) (from dE = N dA with 3/2 bonds per
/// atom); s is the second-order coefficient of T = k l0 (ε − s ε²/2).
double bond_softening(HomogeneousCell& cell, const Card& card) {
  constexpr double small = 0.01;
  const auto tension = [&](double strain) {
    const Matrix2d f = (1 + strain) * Matrix2d::Identity();
    return std::numbers::sqrt3 * card.bond_A() * (1 + strain) * cell.affine(f).trace() / 2;
  };
  const double stiffness = std::numbers::sqrt3 * (card.C11_eV_per_A2 + card.C12_eV_per_A2);
  return -(tension(small) + tension(-small)) / (stiffness * card.bond_A() * small * small);
}

}  // namespace

Card compute_card(const Potential& potential, const std::string& log_file) {
  Card card;
  card.a0_A = lattice_constant(potential, log_file);

  HomogeneousCell cell(potential, {6, 4, card.a0_A}, log_file);
  cell.affine(Matrix2d::Identity());
  card.energy_per_atom_eV = cell.energy_per_atom();
  const Matrix2d along_x = stiffness_along(cell, (Matrix2d() << 1, 0, 0, 0).finished());
  const Matrix2d along_y = stiffness_along(cell, (Matrix2d() << 0, 0, 0, 1).finished());
  const Matrix2d shear = stiffness_along(cell, (Matrix2d() << 0, 1, 1, 0).finished());
  card.C11_eV_per_A2 = (along_x(0, 0) + along_y(1, 1)) / 2;
  card.C12_eV_per_A2 = (along_x(1, 1) + along_y(0, 0)) / 2;
  card.C66_eV_per_A2 = shear(0, 1) / 2;
  card.bond_softening = bond_softening(cell, card);

  const Ripple zigzag = longest_ripple(potential, card.a0_A, true, log_file);
  const Ripple armchair = longest_ripple(potential, card.a0_A, false, log_file);
  card.bending_modulus_zigzag_eV = zigzag.bending_modulus;
  card.bending_modulus_armchair_eV = armchair.bending_modulus;
  card.sublattice_stiffness_eV_per_A2 = (zigzag.sublattice_stiffness + armchair.sublattice_stiffness) / 2;
  if (!(card.C11_eV_per_A2 > std::abs(card.C12_eV_per_A2) && card.bending_modulus_eV() > 0 &&
        card.sublattice_stiffness_eV_per_A2 > 0))
    throw std::runtime_error("the flat sheet is not stable with this potential");
  const ClampMargins margins = clamp_margins(potential, card, log_file);
  card.clamp_margin_bonds = margins.clamp_bonds;
  card.slope_margin_bonds = margins.slope_bonds;
  return card;
}

}  // namespace atomistic
