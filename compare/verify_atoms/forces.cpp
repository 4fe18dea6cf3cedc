// What LAMMPS's forces owe to its energy, and to nobody's being there.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "atomistic/lattice/sheet.hpp"
#include "compare/verify_atoms/groups.hpp"

namespace validate::verify {
namespace {

using atomistic::AtomForces;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

using Cloud = Eigen::Map<const Eigen::Matrix3Xd>;
Cloud cloud(const VectorXd& x) { return Cloud(x.data(), 3, x.size() / 3); }

/// Numbers between −1 and 1, the same on every machine.
VectorXd random_vector(Eigen::Index size, unsigned seed) {
  std::mt19937 generator(seed);
  VectorXd v(size);
  for (double& component : v) component = 2 * (generator() / 4294967295.0) - 1;
  return v;
}

/// A flake whose atoms are off their places in every direction.
VectorXd displaced_flake(const PotentialCard& card, unsigned seed) {
  constexpr double flake_A = 8, edge_A = 3, off_A = 0.06;
  const VectorXd flat = atomistic::make_sheet(flake_A, card.card.a0_A, 0.01, edge_A).positions;
  return flat + off_A * random_vector(flat.size(), seed);
}

VectorXd moved(const VectorXd& x, const Matrix3d& turn, const Vector3d& shift) {
  Eigen::Matrix3Xd image = (turn * cloud(x)).colwise() + shift;
  return Eigen::Map<VectorXd>(image.data(), image.size());
}

Vector3d torque(const VectorXd& x, const VectorXd& f) {
  Vector3d sum = Vector3d::Zero();
  for (Eigen::Index i = 0; i < x.size() / 3; ++i)
    sum += Vector3d(x.segment<3>(3 * i)).cross(Vector3d(f.segment<3>(3 * i)));
  return sum;
}

constexpr double difference_step_A = 5e-4;

/// Along a random direction: central differences with two steps foretell what is left of the finer one, a quarter of
/// the coarser one's error.
void derivative(Ledger& ledger, const std::vector<AtomForces>& at, const VectorXd& direction) {
  const double slope = -at[0].forces_eV_per_A.dot(direction);
  const auto difference = [&](std::size_t k, double h) { return (at[k].energy_eV - at[k + 1].energy_eV) / (2 * h); };
  const double fine = difference(1, difference_step_A), coarse = difference(3, 2 * difference_step_A);
  const double size = at[0].forces_eV_per_A.norm();  // of what a direction of unit components meets
  ledger.equal("(dE/dx + F) along a random direction / |F|", ((4 * fine - coarse) / 3 - slope) / size,
               identity(0, "force is the energy's slope, extrapolated from two central differences"), 1e-6,
               fmt::format("steps of {:g} and {:g} Å", difference_step_A, 2 * difference_step_A));
  ledger.equal("order of the difference's error", std::log2(std::abs(coarse - slope) / std::abs(fine - slope)),
               identity(2, "central differences"), 0.15, "knots of the potentials disturb it");
}

void verify_flake(Ledger& ledger, Laboratory& laboratory, const std::string& potential, unsigned seed) {
  const VectorXd x = displaced_flake(laboratory.card(potential), seed);
  const VectorXd direction = random_vector(x.size(), seed + 100);
  const Matrix3d turn = Eigen::AngleAxisd(0.7 + seed, Vector3d(1, 2, 0.5 + seed).normalized()).toRotationMatrix();
  std::vector<VectorXd> positions = {x};
  for (const double h : {difference_step_A, 2 * difference_step_A})
    for (const double sign : {1.0, -1.0}) positions.push_back(x + sign * h * direction);
  positions.push_back(moved(x, Matrix3d::Identity(), {1.3, -0.7, 0.4}));
  positions.push_back(moved(x, turn, Vector3d::Zero()));
  positions.push_back(x);
  const std::vector<AtomForces> at = laboratory.forces(potential, positions);
  const VectorXd& f = at[0].forces_eV_per_A;
  const double largest = f.cwiseAbs().maxCoeff(), energy = std::abs(at[0].energy_eV);
  ledger.begin(fmt::format("{}, {} atoms off their places, draw {}", potential, x.size() / 3, seed));
  derivative(ledger, at, direction);
  ledger.equal("|sum of forces| / largest", cloud(f).rowwise().sum().norm() / largest, identity(0, "balance of forces"),
               1e-9);
  ledger.equal("|sum of torques| / (largest x 1 Å)", torque(x, f).norm() / largest, identity(0, "balance of torques"),
               1e-8);
  const auto same = [&](const std::string& what, const AtomForces& other, const VectorXd& expected) {
    ledger.equal("energy " + what + " / energy - 1", std::abs(other.energy_eV - at[0].energy_eV) / energy,
                 identity(0, "a body's energy does not depend on where it is"), 1e-10);
    ledger.equal("forces " + what + ", difference / largest",
                 (other.forces_eV_per_A - expected).cwiseAbs().maxCoeff() / largest,
                 identity(0, "forces move with the body"), 1e-8);
  };
  same("after a shift", at[5], f);
  same("after a turn", at[6], moved(f, turn, Vector3d::Zero()));
  same("once more, after the others", at[7], f);
}

}  // namespace

void verify_forces(Ledger& ledger, Laboratory& laboratory) {
  for (const std::string& potential : laboratory.potentials())
    for (const unsigned draw : {1u, 2u}) verify_flake(ledger, laboratory, potential, draw);
}

}  // namespace validate::verify
