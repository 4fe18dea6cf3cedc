// The further forms of a lattice's law: as a table, and with the lattice's directions.
#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>
#include <complex>
#include <iostream>
#include <numbers>

#include "membrane/laws/tension_field.hpp"
#include "membrane/problem.hpp"
#include "states.hpp"
#include "taylor.hpp"

namespace membrane::testing {
namespace {

using std::numbers::pi;

/// The splines of a table that fit a function's S best over a grid of states.
template <class L>
CauchyBornTable tabulated(const L& law, CauchyBornTable table) {
  std::vector<std::pair<double, double>> states;
  for (int i = 0; i <= 24; ++i)
    for (int j = 0; j <= 16; ++j)
      states.emplace_back(table.I.from + (table.I.to - table.I.from) * i / 24, table.q.to * j / 16);
  const auto forces = [&](const auto& of) {
    Eigen::VectorXd all(2 * states.size());
    for (std::size_t k = 0; k < states.size(); ++k) {
      const auto& [I, q] = states[k];
      all.segment<2>(2 * k) = of(Voigt(I / 2 + q, I / 2 - q, 0)).force_eV_per_A2.template head<2>();
    }
    return all;
  };
  table.coefficients_eV_per_A2.assign(table.coefficient_count(), 0);
  const Eigen::VectorXd bare = forces(table);
  Eigen::MatrixXd columns(bare.size(), table.coefficient_count());
  for (int k = 0; k < table.coefficient_count(); ++k) {
    CauchyBornTable one = table;
    one.coefficients_eV_per_A2[k] = 1;
    columns.col(k) = forces(one) - bare;
  }
  const Eigen::VectorXd best = columns.completeOrthogonalDecomposition().solve(forces(law) - bare);
  table.coefficients_eV_per_A2.assign(best.begin(), best.end());
  return table;
}

TEST(SplineBasis, IsAPartitionOfUnityThatReproducesCubics) {
  const SplineAxis axis{-0.2, 0.4, 4};
  const double h = axis.width();
  // The coefficients of x³ are the products of three neighbouring knots, here at -1, 0 and 1 about the
  // middle.
  const auto cube = [&](int k) {
    const double x = axis.from + (k - 1) * h;
    return (x - h) * x * (x + h);
  };
  for (double x : {-0.2, -0.13, 0.0, 0.1, 0.2501, 0.4}) {
    const SplineBasis at = spline_basis(axis, x);
    double unity = 0, value = 0, slope = 0, bend = 0;
    for (int k = 0; k < 4; ++k) {
      unity += at.value[k];
      value += cube(at.first + k) * at.value[k];
      slope += cube(at.first + k) * at.slope[k];
      bend += cube(at.first + k) * at.bend[k];
    }
    EXPECT_NEAR(unity, 1, 1e-15);
    EXPECT_NEAR(value, x * x * x, 1e-15);
    EXPECT_NEAR(slope, 3 * x * x, 1e-14);
    EXPECT_NEAR(bend, 6 * x, 1e-12);
  }
}

TEST(SplineBasis, GoesOverItsEndTwiceDifferentiablyToAConstant) {
  const SplineAxis axis{0, 1, 5};
  const auto sum = [&](double x, auto part) {
    const SplineBasis at = spline_basis(axis, x);
    double total = 0;
    for (int k = 0; k < 4; ++k) total += std::sin(3.0 * (at.first + k)) * (at.*part)[k];
    return total;
  };
  for (double end : {0.0, 1.0})
    for (auto part : {&SplineBasis::value, &SplineBasis::slope, &SplineBasis::bend})
      EXPECT_NEAR(sum(end - 1e-9, part), sum(end + 1e-9, part), 1e-4);
  for (double far : {-3.0, 5.0}) {
    EXPECT_NEAR(sum(far, &SplineBasis::slope), 0, 1e-12);
    EXPECT_NEAR(sum(far, &SplineBasis::value), sum(2 * far, &SplineBasis::value), 1e-12);
  }
  expect_order(
      [&](double t) {
        return std::abs(sum(1.05 + t, &SplineBasis::value) - sum(1.05, &SplineBasis::value) -
                        t * sum(1.05, &SplineBasis::slope));
      },
      1e-3, 2, 1e-15);
  expect_order(
      [&](double t) {
        return std::abs(sum(1.05 + t, &SplineBasis::slope) - sum(1.05, &SplineBasis::slope) -
                        t * sum(1.05, &SplineBasis::bend));
      },
      1e-3, 2, 1e-15);
}

TEST(CauchyBornTable, HoldsAPolynomialOfItsDegreeExactly) {
  // G and A at most cubic in I, B at most bicubic: up to I^6, I^4 q^2 and I^3 q^6.
  const CauchyBorn law = some_lattice();
  const CauchyBornTable table =
      tabulated(law, {law.sheet_modulus_eV_per_A2, law.nu, {-0.1, 0.35, 2}, {0, 0.15, 1}, {}});
  EXPECT_NO_THROW(table.check());
  for (double I : {-0.1, 0.0, 0.07, 0.2, 0.34})
    for (double q : {0.0, 0.01, 0.1, 0.15}) {
      const Voigt strain = principal_at(I / 2 + q, I / 2 - q, 0.4);
      EXPECT_NEAR(table(strain).energy_eV_per_A2, law(strain).energy_eV_per_A2, 1e-9) << I << ' ' << q;
      EXPECT_LE((table(strain).force_eV_per_A2 - law(strain).force_eV_per_A2).norm(), 1e-8) << I << ' ' << q;
      EXPECT_LE((table(strain).tangent_eV_per_A2 - law(strain).tangent_eV_per_A2).norm(), 1e-6) << I << ' ' << q;
    }
}

TEST(CauchyBornTable, FollowsWhatIsNoPolynomialAsItsCellsShrink) {
  const MooneyRivlin rubber{17, 0.3, 0.2};
  const auto error = [&](int cells) {
    const CauchyBornTable table = tabulated(rubber, {17, 0.3, {-0.1, 0.35, cells}, {0, 0.15, cells}, {}});
    double largest = 0;
    for (double I = -0.1; I <= 0.35; I += 0.013)
      for (double q = 0; q <= 0.15; q += 0.007) {
        const Voigt strain(I / 2 + q, I / 2 - q, 0);
        largest = std::max(largest, (table(strain).force_eV_per_A2 - rubber(strain).force_eV_per_A2).norm());
      }
    return largest;
  };
  const double coarse = error(2), fine = error(4);
  std::cout << "table of a rubber's force: largest error " << coarse << ", " << fine << " eV/Å²\n";
  EXPECT_GT(std::log2(coarse / fine), 3);
}

TEST(CauchyBornTable, ParametersWithoutMeaningAreRefused) {
  const CauchyBornTable good = some_table();
  EXPECT_NO_THROW(good.check());
  const auto refused = [&](auto spoil) {
    CauchyBornTable bad = good;
    spoil(bad);
    EXPECT_THROW(bad.check(), std::invalid_argument);
  };
  refused([](auto& t) { t.sheet_modulus_eV_per_A2 = 0; });
  refused([](auto& t) { t.nu = 1; });
  refused([](auto& t) { t.I.cells = 0; });
  refused([](auto& t) { t.I.to = t.I.from; });
  refused([](auto& t) { t.q.from = -0.1; });
  refused([](auto& t) { t.coefficients_eV_per_A2.pop_back(); });
  refused([](auto& t) { t.coefficients_eV_per_A2[3] = std::nan(""); });
}

TEST(CauchyBornSixfold, WithoutAnglesIsIsotropic) {
  const CauchyBorn isotropic = some_lattice();
  CauchyBornSixfold law{isotropic.sheet_modulus_eV_per_A2, isotropic.nu, 0.3, {}};
  for (const auto& [a, b, c] : isotropic.terms) law.terms.push_back({a, b, Sixfold::none, c});
  for (const auto& [name, strain] : named_strains([&](double e) { return law.natural_width(e); })) {
    SCOPED_TRACE(name);
    for (bool relaxed : {false, true}) {
      const Response one = relaxed ? tension_field(law, strain) : law(strain);
      const Response other = relaxed ? tension_field(isotropic, strain) : isotropic(strain);
      EXPECT_NEAR(one.energy_eV_per_A2, other.energy_eV_per_A2, 1e-15);
      EXPECT_LE((one.force_eV_per_A2 - other.force_eV_per_A2).norm(), 1e-13);
      if (strain.norm() == 0 && relaxed) continue;  // no tangent there
      EXPECT_LE((one.tangent_eV_per_A2 - other.tangent_eV_per_A2).norm(), 1e-11);
    }
    EXPECT_EQ(sheet_state(law, strain), sheet_state(isotropic, strain));
  }
}

// The invariants as they are defined, from the components of the strain.
TEST(CauchyBornSixfold, TermsAreTheInvariantsOfTheLattice) {
  const double zigzag = 0.2;
  const CauchyBornSixfold bare{17, 0.3, zigzag, {}};
  for (const auto& [name, strain] : named_strains([](double e) { return -0.3 * e; })) {
    const std::complex<double> in_axes(0.5 * (strain[0] - strain[1]), 0.5 * strain[2]);
    const std::complex<double> d = in_axes * std::polar(1.0, -2 * zigzag);
    double knots = 0;
    for (int k = 0; k < 3; ++k) knots += std::pow(std::abs((d * std::polar(1.0, 2 * pi * k / 3)).real()), 3);
    const double cube = (d * d * d).real();
    const double I = strain[0] + strain[1];
    for (const auto& [term, value] : {std::pair{SixfoldTerm{1, 3, Sixfold::cosine, 7}, 7 * I * cube},
                                      {SixfoldTerm{0, 6, Sixfold::cosine_squared, 7}, 7 * cube * cube},
                                      {SixfoldTerm{2, 3, Sixfold::knots, 7}, 7 * I * I * knots}}) {
      CauchyBornSixfold law = bare;
      law.terms = {term};
      EXPECT_NEAR(law(strain).energy_eV_per_A2 - bare(strain).energy_eV_per_A2, value, 1e-16) << name;
    }
  }
}

TEST(CauchyBornSixfold, IsTheSameEvery60DegreesAndMirroredAtZigzagAndArmchair) {
  const CauchyBornSixfold law = some_hexagonal_lattice(0);
  const auto energy = [&](double angle) { return law(principal_at(0.09, 0.01, angle)).energy_eV_per_A2; };
  for (double angle : {0.1, 0.3}) {
    EXPECT_NEAR(energy(angle + pi / 3), energy(angle), 1e-16);
    EXPECT_NEAR(energy(-angle), energy(angle), 1e-16);
    EXPECT_NEAR(energy(pi / 6 - angle), energy(pi / 6 + angle), 1e-16);
  }
  EXPECT_GT(std::abs(energy(pi / 6) / energy(0) - 1), 1e-3);
}

// Wrinkles that are not along the strain's axes: nothing across them, energy and force continuous over the
// border.
TEST(CauchyBornSixfold, WrinklesTurnToWhereTheForceAcrossVanishes) {
  const CauchyBornSixfold law = some_hexagonal_lattice(0.1);
  const Voigt strain = principal_at(0.1, -0.2, 0.4);
  const Wrinkles at = wrinkles_of(law, strain);
  ASSERT_EQ(at.state, SheetState::wrinkled);
  EXPECT_GT(std::abs(at.angle_rad - 0.4 - pi / 2), 1e-3);
  EXPECT_GT(at.hidden, 0.1);
  const Voigt S = law(Voigt(strain + hidden_strain(law, strain))).force_eV_per_A2;
  EXPECT_NEAR(principal_forces(S).smaller, 0, 1e-14);
  EXPECT_NEAR(S.dot(at.turning()), 0, 1e-14);
  // The border lies where nothing is hidden any more.
  const Voigt border = strain + hidden_strain(law, strain);
  for (double outside : {1e-7, -1e-7}) {
    const Voigt near = border + outside * at.across();
    EXPECT_EQ(sheet_state(law, near), outside > 0 ? SheetState::taut : SheetState::wrinkled);
    EXPECT_LE((tension_field(law, near).force_eV_per_A2 - S).norm(), 1e-5);
  }
}

// A round sheet does not know how its lattice is turned; a quarter is a quarter of it along zigzag and
// armchair.
TEST(CauchyBornSixfold, ARoundSheetAnswersAlikeHoweverItsLatticeIsTurned) {
  const auto force = [](Extent extent, int rings, double zigzag_rad, bool relaxed) {
    Problem problem;
    problem.sheet = DiscSheet{.radius_A = 110, .rings = rings, .extent = extent};
    problem.law = some_hexagonal_lattice(zigzag_rad);
    problem.relaxed = relaxed;
    problem.load = DiscLoad{20};
    problem.levels = {15, 25};
    double last = 0;
    const Report report = solve(problem, [&](const Step& step) {
      last = step.force_eV_per_A;
      return true;
    });
    EXPECT_TRUE(report.converged) << report.reason;
    return last;
  };
  const double here = force(Extent::full, 16, 0, true);
  EXPECT_NEAR(force(Extent::full, 16, pi / 3, true), here, 1e-9 * here);
  EXPECT_NEAR(force(Extent::full, 16, 0.2, true), here, 1e-4 * here);   // the mesh has directions, too
  EXPECT_NEAR(force(Extent::full, 16, 0.2, false), here, 1e-4 * here);  // taut all over
  const double quarter = force(Extent::quarter, 32, 0, true);
  EXPECT_NEAR(force(Extent::quarter, 32, pi / 6, true), quarter, 1e-4 * quarter);
  EXPECT_NEAR(quarter, here, 5e-3 * here);
}

TEST(CauchyBornSixfold, ParametersWithoutMeaningAreRefused) {
  const CauchyBornSixfold good = some_hexagonal_lattice(0.4);
  EXPECT_NO_THROW(good.check());
  const auto refused = [&](auto spoil) {
    CauchyBornSixfold bad = good;
    spoil(bad);
    EXPECT_THROW(bad.check(), std::invalid_argument);
  };
  refused([](auto& l) { l.sheet_modulus_eV_per_A2 = -1; });
  refused([](auto& l) { l.nu = -1; });
  refused([](auto& l) { l.zigzag_rad = INFINITY; });
  refused([](auto& l) { l.terms.push_back({2, 1, Sixfold::none, 1}); });
  refused([](auto& l) { l.terms.push_back({1, 2, Sixfold::cosine, 1}); });
  refused([](auto& l) { l.terms.push_back({6, 3, Sixfold::knots, 1}); });
  refused([](auto& l) { l.terms[2].coefficient_eV_per_A2 = std::nan(""); });
}

}  // namespace
}  // namespace membrane::testing
