#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "atomistic/equilibrium/network_factor.hpp"

namespace {

using namespace atomistic;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Close to AIREBO's card (physics: LAMMPS 29 Sep 2021).
Card airebo_like() {
  return {.a0_A = 2.4192,
          .energy_per_atom_eV = -7.4,
          .C11_eV_per_A2 = 19.99,
          .C12_eV_per_A2 = 7.287,
          .C66_eV_per_A2 = 6.35,
          .bending_modulus_zigzag_eV = 0.967,
          .bending_modulus_armchair_eV = 0.967,
          .sublattice_stiffness_eV_per_A2 = 11.5,
          .bond_softening = 10.9};
}

/// Out-of-plane springs that serve long waves alone, so that the network's own bending modulus is the card's.
Card consistent_out_of_plane() {
  Card card = airebo_like();
  const double long_waves = 16 * card.bending_modulus_eV() * card.area_per_atom_A2() / std::pow(card.bond_A(), 4);
  card.sublattice_stiffness_eV_per_A2 = 4 * long_waves;
  return card;
}

MatrixXd dense(const NetworkFactor& network) { return MatrixXd(network.matrix()).selfadjointView<Eigen::Lower>(); }

VectorXd wrinkled(const Sheet& sheet) {
  VectorXd x = sheet.positions;
  for (int i = 0; i < sheet.atoms(); ++i) {
    x[3 * i] *= 1.02;
    x[3 * i + 2] = 0.4 * std::sin(0.3 * x[3 * i + 1]);
  }
  return x;
}

TEST(SpringNetwork, IsPositiveDefiniteAndSolves) {
  const Sheet sheet = make_sheet(10, 2.4192, 0, 4);
  NetworkFactor network(sheet, spring_constants(airebo_like()));
  network.set_up(wrinkled(sheet));
  const MatrixXd p = dense(network);
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<MatrixXd>(p).eigenvalues().minCoeff(), 0);
  const VectorXd b = VectorXd::Random(p.rows());
  // The factor is rounded to single precision: one refinement makes the solution as good as any.
  VectorXd x = network.solve(b);
  EXPECT_LT((p * x - b).norm(), 1e-5 * b.norm());
  x += network.solve(b - p * x);
  EXPECT_LT((p * x - b).norm(), 1e-9 * b.norm());
}

/// Stiffness of plane waves along x with wave number q, D_ss'(q) = Σ_j P_ij e^{iq(x_j − x_i)} over the atoms j of
/// sublattice s', i one inner atom of sublattice s; its six eigenvalues in ascending order. For small q these are
/// κ q⁴ A (bending), C66 q² A, C11 q² A (A the area per atom), then the sublattices against each other.
Eigen::VectorXd wave_stiffness(const MatrixXd& p, const Sheet& sheet, double q) {
  const std::array<int, 2> inner = {sheet.record[0], sheet.neighbours[sheet.record[0]][0]};
  const auto sublattice = [&](int atom) {  // one whole number of cells away from inner[0], or not
    const Eigen::Vector3d d = sheet.position(atom) - sheet.position(inner[0]);
    const double v = d.y() / (sheet.bond_A * 1.5), whole = std::round(v);
    return std::abs(v - whole) > 1e-6 ? 1 : 0;
  };
  Eigen::MatrixXcd d = Eigen::MatrixXcd::Zero(6, 6);
  for (int s : {0, 1})
    for (int j = 0; j < sheet.free_atoms; ++j) {
      const double phase = q * (sheet.position(j).x() - sheet.position(inner[s]).x());
      d.block<3, 3>(3 * s, 3 * sublattice(j)) += p.block<3, 3>(3 * inner[s], 3 * j) * std::polar(1.0, phase);
    }
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd>(d).eigenvalues();
}

SpringConstants without_identity(const Card& card) {
  SpringConstants constants = spring_constants(card);
  constants.identity_eV_per_A2 = 0;
  return constants;
}

TEST(SpringNetwork, LongWavesInThePlaneHaveTheCardsModuli) {
  const Card card = airebo_like();
  const Sheet sheet = make_sheet(13, card.a0_A, 0, 4);
  NetworkFactor network(sheet, without_identity(card));
  network.set_up(sheet.positions);
  const double q = 2e-3, c11 = card.C11_eV_per_A2, c66 = (c11 - card.C12_eV_per_A2) / 2;
  const Eigen::VectorXd stiffness = wave_stiffness(dense(network), sheet, q) / (q * q * card.area_per_atom_A2());
  EXPECT_NEAR(stiffness[1], c66, 1e-4 * c66);
  EXPECT_NEAR(stiffness[2], c11, 1e-4 * c11);
}

TEST(SpringNetwork, LongWavesOutOfThePlaneBendLikeTheCard) {
  const Card card = consistent_out_of_plane();
  const Sheet sheet = make_sheet(13, card.a0_A, 0, 4);
  NetworkFactor network(sheet, without_identity(card));
  network.set_up(sheet.positions);
  const double q = 0.05, kappa = card.bending_modulus_eV();
  EXPECT_NEAR(wave_stiffness(dense(network), sheet, q)[0] / (std::pow(q, 4) * card.area_per_atom_A2()), kappa,
              0.01 * kappa);
}

/// The geometric mean of what the two ends ask for: too stiff by as much at one end as too soft at the other.
TEST(SpringNetwork, OutOfPlaneSpringsServeBothEndsAlike) {
  const Card card = airebo_like();
  const Sheet sheet = make_sheet(13, card.a0_A, 0, 4);
  NetworkFactor network(sheet, without_identity(card));
  network.set_up(sheet.positions);
  const double q = 0.02;
  const double bending = wave_stiffness(dense(network), sheet, q)[0] /
                         (card.bending_modulus_eV() * std::pow(q, 4) * card.area_per_atom_A2());
  const Eigen::VectorXd at_rest = wave_stiffness(dense(network), sheet, 0);
  double nearest = 0;  // the out-of-plane optical branch is 4 k_o
  for (double k : at_rest)
    if (std::abs(k - 4 * spring_constants(card).out_of_plane_eV_per_A2) < 1e-6) nearest = k;
  EXPECT_NEAR(bending * nearest / card.sublattice_stiffness_eV_per_A2, 1, 0.01);
}

/// A bond at strain ε has the stiffness k (1 − s ε): what the second difference of T = k l0 (ε − s ε²/2) says.
TEST(SpringNetwork, BondsSoftenUnderStrain) {
  const Card card = airebo_like();
  const Sheet sheet = make_sheet(10, card.a0_A, 0, 4);
  SpringConstants constants = spring_constants(card);
  constants.angle_eV = constants.out_of_plane_eV_per_A2 = constants.identity_eV_per_A2 = 1e-9;
  NetworkFactor network(sheet, constants);
  const auto in_plane_stiffness = [&](double strain) {  // of one atom inside, along x: 3/2 (k + T/l)
    network.set_up((1 + strain) * sheet.positions);
    return dense(network)(3 * sheet.record[0], 3 * sheet.record[0]);
  };
  const double k = constants.stretch_eV_per_A2, e = 0.02, s = card.bond_softening;
  EXPECT_NEAR(in_plane_stiffness(0), 1.5 * k, 1e-6);
  EXPECT_NEAR(in_plane_stiffness(e), 1.5 * k * (1 - s * e + (e - s * e * e / 2) / (1 + e)), 1e-6);
}

TEST(SpringNetwork, RefusesACardThatDescribesNoStableSheet) {
  Card card = airebo_like();
  card.bending_modulus_zigzag_eV = card.bending_modulus_armchair_eV = -1;
  EXPECT_THROW(spring_constants(card), std::invalid_argument);
}

}  // namespace
