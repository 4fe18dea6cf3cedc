// A model fitted to a force–depth curve, with what is known of its errors.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "compare/base/describe.hpp"
#include "compare/results/known.hpp"

namespace validate {

inline constexpr std::size_t fewest_points_to_fit = 4;

/// What a closed form reads from a continuum whose E·h and pretension are known, at the depths of the fit, and what
/// follows for the curve fitted: E·h by the ratio, the pretension by the difference.
struct FitBias {
  double Eh_true_eV_per_A2 = 0, Eh_read_eV_per_A2 = 0;
  double pretension_true_eV_per_A2 = 0, pretension_read_eV_per_A2 = 0;
  double Eh_corrected_eV_per_A2 = 0, pretension_corrected_eV_per_A2 = 0;
};

void describe(SameStruct<FitBias> auto& bias, auto&& visit) {
  visit(Field{"Eh_true", unit::membrane_force, "sheet modulus of the membrane"}, bias.Eh_true_eV_per_A2);
  visit(Field{"Eh_read", unit::membrane_force, "what the fit reads from that membrane"}, bias.Eh_read_eV_per_A2);
  visit(Field{"pretension_true", unit::membrane_force, "pretension of the membrane"}, bias.pretension_true_eV_per_A2);
  visit(Field{"pretension_read", unit::membrane_force, "what the fit reads from that membrane"},
        bias.pretension_read_eV_per_A2);
  visit(Field{"Eh_corrected", unit::membrane_force, "fitted sheet modulus × true / read"}, bias.Eh_corrected_eV_per_A2);
  visit(Field{"pretension_corrected", unit::membrane_force, "fitted pretension + true − read"},
        bias.pretension_corrected_eV_per_A2);
}

/// Names of the continua that can be fitted themselves, as Fit::model has them; any other name is a closed form's.
inline constexpr const char* fitted_membrane = "membrane";        ///< St Venant–Kirchhoff's, with the real tip
inline constexpr const char* fitted_third_order = "third-order";  ///< S = E·h E + D E²
inline constexpr const char* fitted_sheet = "sheet";              ///< a potential's own law, with bending

struct Fit {
  std::string model;  ///< name of a closed form, or of a continuum (above)
  double Eh_eV_per_A2 = not_known, Eh_stderr_eV_per_A2 = not_known;
  double pretension_eV_per_A2 = not_known, pretension_stderr_eV_per_A2 = not_known;
  std::array<double, 2> Eh_interval_eV_per_A2{not_known, not_known};
  std::array<double, 2> pretension_interval_eV_per_A2{not_known, not_known};
  double correlation = not_known;
  std::vector<double> correlation_matrix;  ///< of all parameters, row by row: E·h, pretension, then the offsets
  double rms_relative = not_known;         ///< root mean square residual over the largest force
  std::array<double, 2> window_A{not_known, not_known};
  int points = 0;
  double r_squared = not_known, condition_number = not_known;
  double Eh_bootstrap_eV_per_A2 = not_known;                    ///< standard error from refits to drawn residuals
  double pretension_bootstrap_eV_per_A2 = not_known;            ///< the same
  std::optional<double> depth_offset_A, force_offset_eV_per_A;  ///< where asked for
  std::optional<double> depth_offset_stderr_A, force_offset_stderr_eV_per_A;
  std::optional<double> torn_at_A;                        ///< the continuum fitted ends here, and the fit with it
  std::vector<double> fitted_depth_A, residual_eV_per_A;  ///< the points fitted, force − model
  std::vector<double> model_force_eV_per_A;               ///< of a continuum that was fitted, at those depths
  std::optional<FitBias> bias;
  std::vector<std::string> warnings;  ///< what a careful reader would say of this fit
};

void describe(SameStruct<Fit> auto& fit, auto&& visit) {
  visit(Field{"model", unit::none, "closed form by its name; membrane, third-order or sheet: that continuum itself"},
        fit.model);
  visit(Field{"Eh", unit::membrane_force, "fitted sheet modulus"}, fit.Eh_eV_per_A2);
  visit(Field{"Eh_stderr", unit::membrane_force, "its standard error"}, fit.Eh_stderr_eV_per_A2);
  visit(Field{"Eh_interval", unit::membrane_force, "95 % interval by profile likelihood"}, fit.Eh_interval_eV_per_A2);
  visit(Field{"pretension", unit::membrane_force, "fitted pretension"}, fit.pretension_eV_per_A2);
  visit(Field{"pretension_stderr", unit::membrane_force, "its standard error"}, fit.pretension_stderr_eV_per_A2);
  visit(Field{"pretension_interval", unit::membrane_force, "95 % interval by profile likelihood"},
        fit.pretension_interval_eV_per_A2);
  visit(Field{"correlation", unit::none, "correlation of sheet modulus and pretension"}, fit.correlation);
  visit(Field{"correlation_matrix", unit::none, "of all parameters, row by row: E·h, pretension, then the offsets"},
        fit.correlation_matrix);
  visit(Field{"rms_relative", unit::none, "root mean square residual over the largest force"}, fit.rms_relative);
  visit(Field{"window", unit::length, "first and last depth fitted"}, fit.window_A);
  visit(Field{"points", unit::none, "number of points fitted", {.low = fewest_points_to_fit, .low_open = false}},
        fit.points);
  visit(Field{"r_squared", unit::none, "share of the forces' scatter that the fit explains"}, fit.r_squared);
  visit(Field{"condition_number", unit::none, "of the Jacobian with columns of equal length"}, fit.condition_number);
  visit(Field{"Eh_bootstrap", unit::membrane_force, "standard error by residual bootstrap"},
        fit.Eh_bootstrap_eV_per_A2);
  visit(Field{"pretension_bootstrap", unit::membrane_force, "standard error by residual bootstrap"},
        fit.pretension_bootstrap_eV_per_A2);
  visit(Field{"depth_offset", unit::length, "depth of the contact point, fitted"}.where_known(), fit.depth_offset_A);
  visit(Field{"depth_offset_stderr", unit::length, "its standard error"}.where_known(), fit.depth_offset_stderr_A);
  visit(Field{"force_offset", unit::force, "zero of force, fitted"}.where_known(), fit.force_offset_eV_per_A);
  visit(Field{"force_offset_stderr", unit::force, "its standard error"}.where_known(),
        fit.force_offset_stderr_eV_per_A);
  visit(
      Field{"torn_at", unit::length, "the law of the continuum ends at this depth, and the fit with it"}.where_known(),
      fit.torn_at_A);
  visit(Column{"fitted_depth", unit::length, "depths of the points fitted"}.where_known(), fit.fitted_depth_A);
  visit(Column{"residual", unit::force, "force minus the fitted curve there"}.where_known(), fit.residual_eV_per_A);
  visit(Column{"model_force", unit::force, "force of the continuum that was fitted there"}.where_known(),
        fit.model_force_eV_per_A);
  visit(Field{"bias", unit::none, "of this fit, read from a continuum that is known"}.where_known(), fit.bias);
  visit(Field{"warnings", unit::none, "what a careful reader would say of this fit"}, fit.warnings);
}

/// Whether a fit is of a continuum itself, not of a closed form.
inline bool of_continuum(const Fit& fit) {
  return fit.model == fitted_membrane || fit.model == fitted_third_order || fit.model == fitted_sheet;
}

/// The fit of the closed form and that of the continuum among the fits of a curve; null where there is none.
inline const Fit* closed_form_fit(const std::vector<Fit>& fits) {
  const auto found = std::ranges::find_if(fits, [](const Fit& fit) { return !of_continuum(fit); });
  return found == fits.end() ? nullptr : &*found;
}
inline const Fit* continuum_fit(const std::vector<Fit>& fits) {
  const auto found = std::ranges::find_if(fits, of_continuum);
  return found == fits.end() ? nullptr : &*found;
}
inline Fit* closed_form_fit(std::vector<Fit>& fits) {
  return const_cast<Fit*>(closed_form_fit(static_cast<const std::vector<Fit>&>(fits)));
}

/// The fit against the depth up to which points are used.
struct WindowScan {
  std::vector<double> depth_max_A, Eh_eV_per_A2, pretension_eV_per_A2;
};

void describe(SameStruct<WindowScan> auto& scan, auto&& visit) {
  visit(Column{"depth_max", unit::length, "largest depth fitted"}, scan.depth_max_A);
  visit(Column{"Eh", unit::membrane_force, "sheet modulus of that fit"}, scan.Eh_eV_per_A2);
  visit(Column{"pretension", unit::membrane_force, "pretension of that fit"}, scan.pretension_eV_per_A2);
}

}  // namespace validate
