#include "atomistic/thermal/free_energy.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "atomistic/thermal/modes.hpp"

namespace {

using namespace atomistic;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double mass_u = 12.011;

/// A chain with stiffnesses like those of a sheet: eigenvalues from 1e-3 to 110 eV/Å².
MatrixXd chain(double stiffer = 1) {
  MatrixXd h = MatrixXd::Zero(24, 24);
  for (int i = 0; i < 24; ++i) {
    h(i, i) = 2 * 27 * stiffer + 0.3;
    if (i > 0) h(i, i - 1) = h(i - 1, i) = -27 * stiffer;
  }
  h(3, 3) += 2;
  return h;
}

/// Σ of the oscillators' free energies, from their frequencies.
double by_frequencies(const MatrixXd& h, double kT, Statistics statistics) {
  double sum = 0;
  const VectorXd values = Eigen::SelfAdjointEigenSolver<MatrixXd>(h).eigenvalues();
  for (const double value : values) {
    const double omega = std::sqrt(value / (mass_u * constants::atomic_mass_eV_s2_per_A2));
    const double x = constants::hbar_eV_s * omega / kT;
    sum += kT * (statistics == Statistics::classical ? std::log(x) : std::log(2 * std::sinh(x / 2)));
  }
  return sum;
}

/// h on the subspace c·x = 0.
MatrixXd held(const MatrixXd& h, const VectorXd& c) {
  const MatrixXd q = Eigen::HouseholderQR<MatrixXd>(c).householderQ();
  const MatrixXd rest = q.rightCols(q.cols() - 1);
  return rest.transpose() * h * rest;
}

class FreeEnergyOf : public testing::TestWithParam<std::pair<double, Statistics>> {};

/// Differences between two matrices: the constant is left out.
TEST_P(FreeEnergyOf, AChainIsTheSumOverItsFrequencies) {
  const auto [temperature, statistics] = GetParam();
  const double kT = constants::boltzmann_eV_per_K * temperature;
  const VibrationalFreeEnergy energy({.temperature_K = temperature, .statistics = statistics}, mass_u);
  VectorXd c = VectorXd::Zero(24);
  c.head(5).setConstant(0.2);
  DefiniteFactor factor;
  const auto soft = energy(chain().sparseView(), c, factor), stiff = energy(chain(1.1).sparseView(), c, factor);
  ASSERT_TRUE(soft && stiff);
  const double all = by_frequencies(chain(1.1), kT, statistics) - by_frequencies(chain(), kT, statistics);
  const double some =
      by_frequencies(held(chain(1.1), c), kT, statistics) - by_frequencies(held(chain(), c), kT, statistics);
  EXPECT_NEAR(stiff->free_eV - soft->free_eV, all, 1e-3 * all);
  EXPECT_NEAR(stiff->held_eV - soft->held_eV, some, 1e-3 * some);
}

INSTANTIATE_TEST_SUITE_P(At, FreeEnergyOf,
                         testing::Values(std::pair(300.0, Statistics::classical), std::pair(300.0, Statistics::quantum),
                                         std::pair(30.0, Statistics::quantum)),
                         [](const auto& test) {
                           return std::string(test.param.second == Statistics::quantum ? "quantum" : "classical") +
                                  std::to_string(static_cast<int>(test.param.first));
                         });

TEST(FreeEnergy, IsNotKnownWhereAVibrationIsUnstable) {
  MatrixXd h = chain();
  h(0, 0) = -1;
  DefiniteFactor factor;
  EXPECT_FALSE(VibrationalFreeEnergy({.temperature_K = 300}, mass_u)(h.sparseView(), VectorXd(), factor));
}

TEST(LowestModes, AreThoseOfADenseSolver) {
  const MatrixXd h = chain();
  const Eigenpairs modes = lowest_modes(h.sparseView(), 4);
  const VectorXd values = Eigen::SelfAdjointEigenSolver<MatrixXd>(h).eigenvalues();
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(modes.values[static_cast<std::size_t>(k)], values[k], 1e-5 * values[k]);
}

TEST(Frequency, OfTheStiffestVibrationIsGraphites) {
  EXPECT_NEAR(frequency_THz(112, mass_u), 47.7, 0.1);  // 1592 cm⁻¹
  EXPECT_LT(frequency_THz(-0.1, mass_u), 0);
}

}  // namespace
