#include "compare/fitting/curve_row.hpp"

#include <algorithm>
#include <cmath>

namespace validate {

CurveRow row_of(const MeasuredCurve& curve) {
  CurveRow row;
  row.file = curve.source;
  row.index = curve.index;
  row.x_nm = curve.x_nm.value_or(not_known);
  row.y_nm = curve.y_nm.value_or(not_known);
  if (!curve.preparation) return row;
  if (const auto& pull = curve.preparation->pull_off) {
    row.pull_off_eV_per_A = pull->force_eV_per_A;
    row.pull_off_work_eV = pull->work_eV;
  }
  return row;
}

CurveRow row_of(const MeasuredCurve& curve, const FittedCurve& fitted) {
  CurveRow row = row_of(curve);
  const Fit* fit = recommended_fit(fitted.fits);
  if (!fit) return row;
  constexpr double A_per_nm = 10;
  row.model = fit->model;
  row.Eh_eV_per_A2 = fit->Eh_eV_per_A2;
  row.Eh_stderr_eV_per_A2 = fit->Eh_stderr_eV_per_A2;
  row.Eh_low_eV_per_A2 = fit->Eh_interval_eV_per_A2[0];
  row.Eh_high_eV_per_A2 = fit->Eh_interval_eV_per_A2[1];
  // The interval's width knows more of the noise than its own share does.
  double others = 0;
  for (const ErrorSource& source : fit->sources)
    if (source.name != "noise") others += source.Eh_eV_per_A2 * source.Eh_eV_per_A2;
  const double rest = fit->Eh_stderr_eV_per_A2 * fit->Eh_stderr_eV_per_A2 - others;
  const auto noise = std::ranges::find(fit->sources, "noise", &ErrorSource::name);
  const double own = noise == fit->sources.end() ? 0 : noise->Eh_eV_per_A2;
  row.Eh_noise_eV_per_A2 = std::max(own, std::sqrt(std::max(rest, 0.0)));
  row.pretension_eV_per_A2 = fit->pretension_eV_per_A2;
  row.pretension_stderr_eV_per_A2 = fit->pretension_stderr_eV_per_A2;
  row.pretension_low_eV_per_A2 = fit->pretension_interval_eV_per_A2[0];
  row.pretension_high_eV_per_A2 = fit->pretension_interval_eV_per_A2[1];
  const double contact_A = A_per_nm * fit->contact_nm.value_or(0);
  if (curve.preparation)
    row.height_A = (curve.preparation->height_turned ? -1 : 1) * (curve.preparation->contact_A + contact_A);
  row.contact_nm = fit->contact_nm.value_or(not_known);
  row.force_zero_nN = fit->force_zero_nN.value_or(not_known);
  row.slope_N_per_m = fit->slope_nN_per_nm.value_or(not_known);
  row.sigma_force_nN = fit->sigma_force_nN.value_or(not_known);
  row.sigma_depth_nm = fit->sigma_depth_nm.value_or(not_known);
  row.deepest_A = std::ranges::max(fitted.depth_A) - contact_A;
  row.largest_force_eV_per_A = std::ranges::max(fitted.force_eV_per_A);
  row.chi2_per_dof = fit->chi2_per_dof;
  row.rms_relative = fit->rms_relative;
  row.runs_z = fit->runs_z;
  row.points = fit->points;
  return row;
}

}  // namespace validate
