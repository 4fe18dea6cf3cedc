#include "atomistic/card.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "atomistic/lammps.hpp"

namespace atomistic {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double half_height_A = 20;  ///< the cell is empty above and below the sheet

/// Rectangular four-atom cell, zigzag along x: a × √3 a, repeated.
struct Supercell {
  int along_x, along_y;
  double a;

  int atoms() const { return 4 * along_x * along_y; }
  static int sublattice(int atom) { return atom % 2; }
  double area() const { return along_x * along_y * a * a * std::numbers::sqrt3; }

  VectorXd positions() const {
    const double b = std::numbers::sqrt3 * a;
    // bonds along y: each pair (0, 1) and (2, 3) is one of them
    const double basis[4][2] = {{0, 0}, {0, 1.0 / 3}, {0.5, 0.5}, {0.5, 5.0 / 6}};
    VectorXd x(3 * atoms());
    int k = 0;
    for (int i = 0; i < along_x; ++i)
      for (int j = 0; j < along_y; ++j)
        for (const auto& [u, v] : basis) x.segment<3>(3 * k++) << a * (i + u), b * (j + v), 0.0;
    return x;
  }

  Box box(const Matrix2d& f = Matrix2d::Identity()) const {
    return {.low = {0, 0, -half_height_A},
            .high = {f(0, 0) * along_x * a, f(1, 1) * along_y * std::numbers::sqrt3 * a, half_height_A},
            .tilt_xy = f(0, 1) * along_y * std::numbers::sqrt3 * a,
            .periodic = true};
  }
};

/// Flat cell under a homogeneous upper-triangular deformation gradient, sublattice 1 shifted until it is in
/// balance.
class HomogeneousCell {
 public:
  HomogeneousCell(const Potential& potential, const Supercell& cell, const std::string& log_file)
      : cell_(cell), flat_(cell.positions()), forces_(potential, cell.box(), flat_, log_file) {}

  double energy_per_atom() const { return energy_ / cell_.atoms(); }

  /// Membrane force N (Cauchy, eV/Å²) with the atoms placed affinely.
  Matrix2d affine(const Matrix2d& f) {
    forces_.set_box(cell_.box(f));
    shift_.setZero();
    evaluate(f);
    return forces_.membrane_force();
  }

  /// Membrane force with the inner displacement relaxed by Newton's method.
  Matrix2d relaxed(const Matrix2d& f) {
    forces_.set_box(cell_.box(f));
    shift_.setZero();
    Vector2d residual = evaluate(f);
    const Matrix2d stiffness = shift_stiffness(f, residual);
    for (int i = 0; i < 30 && residual.norm() > 1e-11 * stiffness.norm(); ++i) {
      shift_ += stiffness.inverse() * residual;
      residual = evaluate(f);
    }
    return forces_.membrane_force();
  }

 private:
  /// Mean in-plane force on an atom of sublattice 1.
  Vector2d evaluate(const Matrix2d& f) {
    VectorXd x = flat_;
    for (int i = 0; i < cell_.atoms(); ++i)
      x.segment<2>(3 * i) = f * flat_.segment<2>(3 * i) + Supercell::sublattice(i) * shift_;
    energy_ = forces_.evaluate(x, atom_forces_);
    Vector2d mean = Vector2d::Zero();
    for (int i = 0; i < cell_.atoms(); ++i)
      if (Supercell::sublattice(i) == 1) mean += atom_forces_.segment<2>(3 * i);
    return mean / (cell_.atoms() / 2.0);
  }

  Matrix2d shift_stiffness(const Matrix2d& f, const Vector2d& at_rest) {
    constexpr double small = 1e-4;
    Matrix2d k;
    for (int c : {0, 1}) {
      shift_ = small * Vector2d::Unit(c);
      k.col(c) = (at_rest - evaluate(f)) / small;
    }
    shift_.setZero();
    return k;
  }

  Supercell cell_;
  VectorXd flat_, atom_forces_;
  ForceField forces_;
  Vector2d shift_ = Vector2d::Zero();
  double energy_ = 0;
};

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
    throw std::runtime_error(
        fmt::format("no flat sheet without membrane force found near a = 2.46 Å (reached {})", a));
  return a;
}

/// Second Piola–Kirchhoff membrane force J F⁻¹ N F⁻ᵀ.
Matrix2d pulled_back(const Matrix2d& f, const Matrix2d& cauchy) {
  const Matrix2d inverse = f.inverse();
  return f.determinant() * inverse * cauchy * inverse.transpose();
}

/// Upper-triangular F with FᵀF = 1 + 2E.
Matrix2d gradient_of_strain(const Matrix2d& strain) {
  const Matrix2d c = Matrix2d::Identity() + 2 * strain;
  return Eigen::LLT<Matrix2d>(c).matrixU();
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
      for (int i = moved; i < cell.atoms(); i += 2)
        x[3 * i + 2] = amplitude * (wave(i) * std::conj(phase)).real();
      forces.evaluate(x, f, true);
      for (int i = 0; i < cell.atoms(); ++i)
        stiffness(Supercell::sublattice(i), moved) -= f[3 * i + 2] * std::conj(wave(i)) * phase;
    }
  }
  stiffness /= amplitude * cell.atoms() / 2.0;
  const Eigen::Matrix2cd hermitian = (stiffness + stiffness.adjoint()) / 2;
  const Eigen::Vector2d eigenvalues =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2cd>(hermitian).eigenvalues();
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
  return card;
}

}  // namespace atomistic
