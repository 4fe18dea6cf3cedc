// The relaxed (tension-field) form of a law that has directions of its own: the wrinkles choose theirs.
#pragma once

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <numbers>

#include "membrane/fault.hpp"
#include "membrane/laws/principal.hpp"
#include "membrane/laws/response.hpp"
#include "membrane/laws/sheet_state.hpp"

namespace membrane {

/// The relaxed energy is the least of psi(Ē + P) over the strains P ⪰ 0 that wrinkles can hide. For a convex
/// law that means P = 0 where S(Ē) has no compressive part (taut), P = −Ē where Ē has no extension (slack),
/// and else P = a n⊗n with a > 0 and S n = 0 (wrinkled), n at an angle β to the x axis.
struct Wrinkles {
  SheetState state = SheetState::taut;
  double hidden = 0;  ///< a; NaN where no n was found
  double angle_rad = 0;

  /// n⊗n and its first two derivatives by β, as strains [E11, E22, 2 E12].
  Voigt across() const { return {c() * c(), s() * s(), 2 * c() * s()}; }
  Voigt turning() const { return {-2 * c() * s(), 2 * c() * s(), 2 * (c() * c() - s() * s())}; }
  Voigt bending() const { return 2 * (Voigt(1, 1, 0) - 2 * across()); }

  Voigt strain() const { return state == SheetState::wrinkled ? Voigt(hidden * across()) : Voigt::Zero(); }

 private:
  double c() const { return std::cos(angle_rad); }
  double s() const { return std::sin(angle_rad); }
};

/// Angle of the axis of the smaller principal value.
inline double minor_axis_rad(const Principal& at) {
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

/// The state at an offset strain Ē. The width at which the force across the larger strain vanishes decides
/// where to look, not the sign of the force, so that a law that softens in compression is judged rightly too.
template <DirectionalLaw L>
Wrinkles wrinkles_of(const L& law, const Voigt& strain) {
  const Principal axes = principal_strains(strain);
  if (!(axes.larger > 0)) return {SheetState::slack, 0, 0};
  if (broken(Fault::wrinkled_as_taut)) return {};
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
SheetState sheet_state(const L& law, const Voigt& offset_strain) {
  return wrinkles_of(law, offset_strain).state;
}

/// What wrinkles hide of the strain Ē across them, as [E11, E22, 2 E12]. Zero where there are none.
template <DirectionalLaw L>
Voigt hidden_strain(const L& law, const Voigt& offset_strain) {
  return wrinkles_of(law, offset_strain).strain();
}

/// The relaxed law. Wrinkled: psi and S of Ē + a n⊗n, S = S1 t⊗t; and since a and n follow the strain,
/// dS/dE = D − D G (Gᵀ D G + K)⁻¹ Gᵀ D, G = [d(n⊗n)/dβ, n⊗n], where K holds 2 S1/a against turning.
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

}  // namespace membrane
