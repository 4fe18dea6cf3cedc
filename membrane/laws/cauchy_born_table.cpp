#include "membrane/laws/cauchy_born_table.hpp"

#include <cmath>

#include "membrane/base/refusal.hpp"

namespace membrane {

InvariantEnergy CauchyBornTable::energy(double trace, double shear) const {
  const SplineBasis i = spline_basis(I, trace);
  const SplineBasis j = spline_basis(q, shear);
  double G[3] = {}, A[3] = {};  // value, first and second derivative
  double B = 0, B_I = 0, B_q = 0, B_II = 0, B_Iq = 0, B_qq = 0;
  for (int m = 0; m < 4; ++m) {
    const double* const c = coefficients_eV_per_A2.data() + i.first + m;
    G[0] += c[0] * i.value[m], G[1] += c[0] * i.slope[m], G[2] += c[0] * i.bend[m];
    const double a = c[I.size()];
    A[0] += a * i.value[m], A[1] += a * i.slope[m], A[2] += a * i.bend[m];
    const double* const row = coefficients_eV_per_A2.data() + 2 * I.size() + (i.first + m) * q.size() + j.first;
    double along = 0, along_q = 0, along_qq = 0;
    for (int n = 0; n < 4; ++n)
      along += row[n] * j.value[n], along_q += row[n] * j.slope[n], along_qq += row[n] * j.bend[n];
    B += along * i.value[m], B_I += along * i.slope[m], B_II += along * i.bend[m];
    B_q += along_q * i.value[m], B_Iq += along_q * i.slope[m], B_qq += along_qq * i.value[m];
  }
  const double t = trace, t2 = t * t, s = shear, s2 = s * s;
  InvariantEnergy at = quadratic_energy(sheet_modulus_eV_per_A2, nu, t, s);
  at.W += t * t2 * G[0] + t * s2 * A[0] + s * s2 * B;
  at.W_I += t2 * (3 * G[0] + t * G[1]) + s2 * (A[0] + t * A[1]) + s * s2 * B_I;
  at.W_q_over_q += 2 * t * A[0] + s * (3 * B + s * B_q);
  at.W_II += t * (6 * G[0] + t * (6 * G[1] + t * G[2])) + s2 * (2 * A[1] + t * A[2]) + s * s2 * B_II;
  at.W_Iq += 2 * s * (A[0] + t * A[1]) + s2 * (3 * B_I + s * B_Iq);
  at.W_qq += 2 * t * A[0] + s * (6 * B + s * (6 * B_q + s * B_qq));
  return at;
}

Response CauchyBornTable::operator()(const Voigt& strain) const { return isotropic_response(*this, strain); }

double CauchyBornTable::natural_width(double axial_strain) const { return solve_natural_width(*this, axial_strain); }

UniaxialResponse CauchyBornTable::uniaxial(double axial_strain) const { return uniaxial_response(*this, axial_strain); }

void CauchyBornTable::check() const {
  if (!(sheet_modulus_eV_per_A2 > 0) || !std::isfinite(sheet_modulus_eV_per_A2))
    refuse("law.sheet_modulus_eV_per_A2", sheet_modulus_eV_per_A2, "must be positive and finite");
  if (!(nu > -1 && nu < 1)) refuse("law.nu", nu, "must lie between -1 and 1, both excluded");
  for (const SplineAxis& axis : {I, q}) {
    if (axis.cells < 1) refuse("law.I or q.cells", axis.cells, "a table needs at least one cell each way");
    if (!(axis.to > axis.from) || !std::isfinite(axis.to - axis.from))
      refuse("law.I or q.to", axis.to, "a table's range must end above its beginning");
  }
  if (q.from != 0) refuse("law.q.from", q.from, "must be 0: the shear of a sheet at rest");
  if (static_cast<int>(coefficients_eV_per_A2.size()) != coefficient_count())
    refuse("law.coefficients_eV_per_A2", coefficients_eV_per_A2.size(),
           "must be (I.cells + 3) (q.cells + 5) in number");
  for (double c : coefficients_eV_per_A2)
    if (!std::isfinite(c)) refuse("law.coefficients_eV_per_A2", c, "every coefficient must be finite");
}

std::vector<LawForm<CauchyBornTable>> CauchyBornTable::forms() { return {}; }

/// Coefficients without any order.
std::vector<LawExample<CauchyBornTable>> CauchyBornTable::examples() {
  CauchyBornTable law{17.33, 0.3645, {-0.2, 0.35, 3}, {0, 0.18, 2}, {}};
  for (int k = 0; k < law.coefficient_count(); ++k)
    law.coefficients_eV_per_A2.push_back(-4 + 1.5 * std::sin(1.7 * k * k));
  return {{with_nu("Cauchy-Born table", law.nu), law}};
}

}  // namespace membrane
