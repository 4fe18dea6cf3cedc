// The spatial description of Gil et al. 2010, Eqs. 1, 3, 4 and 13 (the latter two corrected), against the
// material one that the code computes: Cauchy force and spatial tangent from principal stretches, and pushed
// forward. The printed forms of Eqs. 4 and 13 are shown not to agree.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "membrane/laws/prestress.hpp"
#include "membrane/laws/tension_field.hpp"
#include "states.hpp"

namespace membrane::testing {
namespace {

double green(double log_stretch) { return 0.5 * std::expm1(2 * log_stretch); }

/// First and second derivatives of f(ln lambda1, ln lambda2) at a point, by differences of fourth order.
struct LogDerivatives {
  Eigen::Vector2d first;
  Eigen::Matrix2d second;

  template <class F>
  LogDerivatives(F f, const Eigen::Vector2d& at) {
    const double h = 2e-3;
    const auto slope = [&](auto g, int axis) {
      const auto along = [&](double t) { return g(Eigen::Vector2d(at + t * Eigen::Vector2d::Unit(axis))); };
      return (8 * (along(h) - along(-h)) - (along(2 * h) - along(-2 * h))) / (12 * h);
    };
    for (int a = 0; a < 2; ++a) {
      first[a] = slope(f, a);
      for (int b = 0; b < 2; ++b)
        second(a, b) = slope(
            [&](const Eigen::Vector2d& x) {
              const auto along = [&](double t) { return f(Eigen::Vector2d(x + t * Eigen::Vector2d::Unit(b))); };
              return (8 * (along(h) - along(-h)) - (along(2 * h) - along(-2 * h))) / (12 * h);
            },
            a);
    }
  }
};

/// A deformation in the plane: stretches along axes at `angle`, then a rotation.
struct Stretched {
  double l1, l2, J;
  Eigen::Matrix2d F;
  Voigt strain;                   ///< Green–Lagrange
  Voigt along, across, shearing;  ///< n1⊗n1, n2⊗n2, n1⊗n2 + n2⊗n1, spatial, as [xx, yy, xy]

  Stretched(double log1, double log2, double angle = 0.7, double rotation = 0.5)
      : l1(std::exp(log1)), l2(std::exp(log2)), J(l1 * l2) {
    const Eigen::Matrix2d N = Eigen::Rotation2D<double>(angle).toRotationMatrix();
    F = Eigen::Rotation2D<double>(rotation).toRotationMatrix() * N * Eigen::Vector2d(l1, l2).asDiagonal() *
        N.transpose();
    strain = principal_at(green(log1), green(log2), angle);
    const double c = std::cos(angle + rotation);
    const double s = std::sin(angle + rotation);
    along = {c * c, s * s, c * s};
    across = {s * s, c * c, -c * s};
    shearing = {-2 * c * s, 2 * c * s, c * c - s * s};
  }

  /// Takes [S11, S22, S12] to F S Fᵀ.
  Eigen::Matrix3d push() const {
    Eigen::Matrix3d T;
    T << F(0, 0) * F(0, 0), F(0, 1) * F(0, 1), 2 * F(0, 0) * F(0, 1),  //
        F(1, 0) * F(1, 0), F(1, 1) * F(1, 1), 2 * F(1, 0) * F(1, 1),   //
        F(0, 0) * F(1, 0), F(0, 1) * F(1, 1), F(0, 0) * F(1, 1) + F(0, 1) * F(1, 0);
    return T;
  }
  Voigt cauchy(const Response& at) const { return push() * at.force_eV_per_A2 / J; }
  Eigen::Matrix3d tangent(const Response& at) const { return push() * at.tangent_eV_per_A2 * push().transpose() / J; }
};

/// Energy of an unrelaxed law over (ln lambda1, ln lambda2).
template <class L>
auto log_energy(const L& law) {
  return [&law](const Eigen::Vector2d& x) { return law(Voigt(green(x[0]), green(x[1]), 0)).energy_eV_per_A2; };
}

TEST(Spatial, PrincipalFormsOfStressAndTangentAreThePushedForwardOnes) {
  over_laws([]<class L>(const L& law) {
    if (!IsotropicLaw<L>) return;  // strain and force have no common axes
    for (const auto& [a, b] : {std::pair{0.08, 0.02}, {0.1, -0.05}, {-0.02, -0.06}}) {
      const Stretched at(a, b);
      const LogDerivatives psi(log_energy(law), {a, b});
      const double s1 = psi.first[0] / at.J;  // Eq. 1
      const double s2 = psi.first[1] / at.J;
      const Response material = law(at.strain);
      EXPECT_LE((at.cauchy(material) - s1 * at.along - s2 * at.across).norm(), 1e-8);
      const double turning = (s1 * at.l2 * at.l2 - s2 * at.l1 * at.l1) / (at.l1 * at.l1 - at.l2 * at.l2);
      const Eigen::Matrix2d K = psi.second / at.J - 2 * Eigen::Vector2d(s1, s2).asDiagonal().toDenseMatrix();
      const Eigen::Matrix3d spatial = K(0, 0) * at.along * at.along.transpose() +
                                      K(1, 1) * at.across * at.across.transpose() +
                                      K(0, 1) * (at.along * at.across.transpose() + at.across * at.along.transpose()) +
                                      turning * at.shearing * at.shearing.transpose();  // Eq. 3
      EXPECT_LE((at.tangent(material) - spatial).norm(), 1e-6);
    }
  });
}

TEST(Misprint, Equation4) {
  // Limit of ½ (σ1 λ2² − σ2 λ1²)/(λ1² − λ2²) for λ1 → λ2; printed without −σ/2.
  const StVenantKirchhoff law{5.864, 0.19};
  const auto half_turning = [&](double a, double b) {
    const Stretched at(a, b);
    const Principal s = principal_forces(at.cauchy(law(at.strain)));
    return 0.5 * (s.larger * at.l2 * at.l2 - s.smaller * at.l1 * at.l1) / (at.l1 * at.l1 - at.l2 * at.l2);
  };
  const double both = 0.05;
  const Stretched at(both, both);
  const LogDerivatives psi(log_energy(law), {both, both});
  const double sigma = psi.first[1] / at.J;
  const double printed = (psi.second(1, 1) - psi.second(0, 1)) / (4 * at.J);
  EXPECT_NEAR(half_turning(both + 1e-5, both - 1e-5), printed - sigma / 2, 1e-7);
  EXPECT_GT(sigma / 2, 0.1);
  // It is what makes the tangent isotropic in the plane of equal stretches: c1212 = (c1111 − c1122)/2.
  const Eigen::Matrix3d c = at.tangent(law(at.strain));
  EXPECT_NEAR(2 * (printed - sigma / 2), 0.5 * (c(0, 0) - c(0, 1)), 1e-8);
}

TEST(Misprint, Equation13) {
  // Coefficient of the turning term of a wrinkled sheet: σ11 λ2²/(λ1² − λ2²), with the whole σ11 and the λ2
  // that the sheet has; printed E λ1² λ2² (λ1² − 1)/(4 J (λ1² − λ2²)): half of it, and without prestress.
  const double E = 5.864;
  const StVenantKirchhoff law{E, 0.19};
  for (double prestress : {0.0, 0.12}) {
    const Stretched at(0.06, -0.2);
    const Voigt offset = offset_strain(law, Voigt(prestress, prestress, 0));
    const Response material = tension_field(law, Voigt(at.strain + offset));
    ASSERT_EQ(sheet_state(law, principal_strains(at.strain + offset)), SheetState::wrinkled);
    const double l1 = at.l1 * at.l1;
    const double l2 = at.l2 * at.l2;
    const double s1 = E * 0.5 * (l1 - 1) + (1 - law.nu) * prestress;
    const double sigma = l1 * s1 / at.J;
    EXPECT_LE((at.cauchy(material) - sigma * at.along).norm(), 1e-14);
    const auto spatial = [&](double turning) -> Eigen::Matrix3d {
      return E * l1 * l1 / at.J * at.along * at.along.transpose() + turning * at.shearing * at.shearing.transpose();
    };
    const double corrected = sigma * l2 / (l1 - l2);
    const double printed = E * l1 * l2 * (l1 - 1) / (4 * at.J * (l1 - l2));
    EXPECT_LE((at.tangent(material) - spatial(corrected)).norm(), 1e-13);
    EXPECT_GT((at.tangent(material) - spatial(printed)).norm(), 0.3);
    if (prestress == 0) {
      EXPECT_NEAR(printed, corrected / 2, 1e-14);
    }
  }
}

}  // namespace
}  // namespace membrane::testing
