// Hencky's clamped disc under uniform pressure p: moderate slopes, small strain (Z. Math. Phys. 63 (1915)
// 311).
//
// With n = N_r / (E·h P²), P = (pa/E·h)^(1/3), rho = r/a:  n² (rho n'' + 3 n') = −rho/8, hence the power
// series n = Σ b_k rho^(2k) with Σ_{i+j=m} (n²)_i 4(j+1)(j+2) b_{j+1} = −δ_{m0}/8; b_0 from the clamped rim,
// n' + (1 − nu) n = 0 at rho = 1. Then w' = −p r/(2 N_r):  w0 = C a P,  C = ½ ∫ rho/n drho.
// Fichter, NASA TP-3658 (1997), corrects Hencky's printed coefficients (b_5 onwards).
// Accuracy: twelve digits for nu in [0, ½] with 60 terms (the terms doubled: hencky_test).
#pragma once

namespace reference {

struct Hencky {
  double height;        ///< C = w0 / (a P)
  double centre_force;  ///< b_0 = N_r(0) / (E·h P²)
};

Hencky hencky(double nu, int terms = 60);

}  // namespace reference
