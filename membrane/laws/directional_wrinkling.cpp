#include "membrane/laws/directional_wrinkling.hpp"

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <numbers>

#include "membrane/laws/cauchy_born_sixfold.hpp"
#include "membrane/laws/principal.hpp"

namespace membrane {
namespace {

/// Angle of the axis of the smaller principal value.
double minor_axis_rad(const Principal& at) {
  return 0.5 * std::atan2(at.sin_2theta, at.cos_2theta) + 0.5 * std::numbers::pi;
}

/// Newton's method on S:n⊗n = 0 and S:d(n⊗n)/dβ = 0 from a guess. A negative a ends at nothing hidden: NaN.
template <DirectionalLaw L>
Wrinkles settle_wrinkles(const L& law, const Voigt& strain, Wrinkles guess) {
  constexpr int most_iterations = 40;
  constexpr double longest_turn = 0.3;
  for (int i = 0; i < most_iterations; ++i) {
    const Voigt N = guess.across(), N1 = guess.turning();
    const Response at = law(Voigt(strain + guess.hidden * N));
    const Voigt& S = at.force_eV_per_A2;
    const auto& D = at.tangent_eV_per_A2;
    Eigen::Matrix2d J;
    J << N.dot(D * N), guess.hidden * N.dot(D * N1) + S.dot(N1),  //
        N1.dot(D * N), guess.hidden * N1.dot(D * N1) + S.dot(guess.bending());
    Eigen::Vector2d step = -J.inverse() * Eigen::Vector2d(S.dot(N), S.dot(N1));
    if (!step.allFinite()) break;
    if (std::abs(step[1]) > longest_turn) step *= longest_turn / std::abs(step[1]);
    guess.hidden += step[0];
    guess.angle_rad += step[1];
    if (std::abs(step[0]) <= 1e-9 * strain.norm() && std::abs(step[1]) <= 1e-8) return guess;
  }
  guess.hidden = std::numeric_limits<double>::quiet_NaN();
  return guess;
}

}  // namespace

Voigt Wrinkles::across() const {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {c * c, s * s, 2 * c * s};
}

Voigt Wrinkles::turning() const {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {-2 * c * s, 2 * c * s, 2 * (c * c - s * s)};
}

Voigt Wrinkles::bending() const { return 2 * (Voigt(1, 1, 0) - 2 * across()); }

Voigt Wrinkles::strain() const { return state == SheetState::wrinkled ? Voigt(hidden * across()) : Voigt::Zero(); }

template <DirectionalLaw L>
Wrinkles wrinkles_of(const L& law, const Voigt& strain) {
  const Principal axes = principal_strains(strain);
  if (!(axes.larger > 0)) return {SheetState::slack, 0, 0};
  const double missing = -law.nu * axes.larger - axes.smaller;
  if (missing > 0) {
    const Wrinkles at = settle_wrinkles(law, strain, {SheetState::wrinkled, missing, minor_axis_rad(axes)});
    if (!(at.hidden <= 0)) return at;
  }
  const Principal forces = principal_forces(law(strain).force_eV_per_A2);
  if (!(forces.smaller < 0)) return {};
  const Wrinkles at = settle_wrinkles(law, strain, {SheetState::wrinkled, 0, minor_axis_rad(forces)});
  return at.hidden <= 0 ? Wrinkles{} : at;
}

template <DirectionalLaw L>
Response tension_field(const L& law, const Voigt& offset_strain) {
  const Wrinkles wrinkles = wrinkles_of(law, offset_strain);
  if (wrinkles.state == SheetState::slack) return {};
  Response at = law(Voigt(offset_strain + wrinkles.strain()));
  if (wrinkles.state == SheetState::taut) return at;
  const double against_turning = at.force_eV_per_A2.dot(wrinkles.bending());
  const double scale = std::sqrt(wrinkles.hidden / against_turning);  // 0 at the taut border
  Eigen::Matrix<double, 3, 2> G;
  G << scale * wrinkles.turning(), wrinkles.across();
  const Eigen::Matrix<double, 3, 2> DG = at.tangent_eV_per_A2 * G;
  Eigen::Matrix2d A = G.transpose() * DG;
  A(0, 0) += 1;
  at.tangent_eV_per_A2 -= DG * A.inverse() * DG.transpose();
  return at;
}

template Wrinkles wrinkles_of(const CauchyBornSixfold&, const Voigt&);
template Response tension_field(const CauchyBornSixfold&, const Voigt&);

}  // namespace membrane
