// A disc under pressure that stays normal to it (follower), at finite strain and slope.
//
// The pressure's vertical pull on what lies inside the deformed radius r is p π r² exactly, so V = p r²/2,
// and its horizontal part adds to the hoop force (svk_sheet.hpp):  H' = T2 − p r λ1 sin φ, φ the slope below
// the horizontal. In x = ln R with λ2 = r/R, v = V/R = p λ2² R/2:
//   dt/dx = T2 − t − p R λ2 λ1 sin φ.
// Rim: clamped (r = a), or free to move in its plane: H = 0, where the sheet is vertical. Two such sheets
// joined at the rim are the Mylar balloon, whose meridian wrinkles follow (mylar_balloon.hpp). The membrane
// force at the axis is shot for. Green & Adkins, Large Elastic Deformations, ch. 4.
// Accuracy: nine digits taut; with wrinkles, whose border no step hits, five with
// 256 steps and seven with 1024 (pressure_test).
#pragma once

#include "reference/svk_sheet.hpp"

namespace reference {

enum class Rim { clamped, sliding };

struct SvkPressureState {
  double height;      ///< of the centre over the rim
  double rim_radius;  ///< deformed
  double volume;      ///< between sheet and the rim's plane
  double energy;      ///< of the sheet, 0 at rest
};

/// State of a disc of material radius a under the pressure p > 0.
SvkPressureState svk_pressure(const SvkSheet& sheet, double radius, double pressure, Rim rim, int steps = 128);

}  // namespace reference
