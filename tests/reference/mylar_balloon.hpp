// The Mylar balloon: two discs of inextensible sheet that wrinkles freely, joined at the rims and inflated.
//
// Only the meridian bears force: N cos φ = 0 at the equator and p r² = R0² p sin φ, sin φ = (r/R0)². Its
// length is the flat radius a, hence with t = r/R0:
//   a/R0 = ∫ dt/√(1 − t⁴) = K/√2,   w0/R0 = ∫ t² dt/√(1 − t⁴) = √2 (E − K/2),  K, E at k² = ½.
// Paulsen, Am. Math. Monthly 101 (1994) 953; Mladenov & Oprea, Am. Math. Monthly 110 (2003) 761.
#pragma once

namespace reference {

struct MylarBalloon {
  double height;  ///< w0/a: half the balloon's thickness
  double radius;  ///< R0/a, inflated
};

MylarBalloon mylar_balloon();

}  // namespace reference
