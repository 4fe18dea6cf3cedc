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

/// What a model reads from a continuum whose E·h and pretension are known, at the depths of the fit.
struct FitBias {
  double Eh_true_eV_per_A2 = 0, Eh_read_eV_per_A2 = 0;
  double pretension_true_eV_per_A2 = 0, pretension_read_eV_per_A2 = 0;
};

void describe(SameStruct<FitBias> auto& bias, auto&& visit) {
  visit(Field{"Eh_true", unit::membrane_force, "sheet modulus of the continuum"}, bias.Eh_true_eV_per_A2);
  visit(Field{"Eh_read", unit::membrane_force, "what this model reads from it"}, bias.Eh_read_eV_per_A2);
  visit(Field{"pretension_true", unit::membrane_force, "pretension of the continuum"}, bias.pretension_true_eV_per_A2);
  visit(Field{"pretension_read", unit::membrane_force, "what this model reads from it"},
        bias.pretension_read_eV_per_A2);
}

/// What one source contributes to the standard errors of a fit.
struct ErrorSource {
  std::string name;  ///< noise, numerical, or an input: radius, nu, tip-radius, …
  double Eh_eV_per_A2 = 0, pretension_eV_per_A2 = 0;
};

void describe(SameStruct<ErrorSource> auto& source, auto&& visit) {
  visit(Field{"name", unit::none, "noise, numerical, or the input that is uncertain"}, source.name);
  visit(Field{"Eh", unit::membrane_force, "standard error of E·h from this source alone"}, source.Eh_eV_per_A2);
  visit(Field{"pretension", unit::membrane_force, "standard error of the pretension from this source alone"},
        source.pretension_eV_per_A2);
}

/// Names of the continua that can be fitted themselves, as Fit::model has them; any other name is a closed form's.
inline constexpr const char* fitted_membrane = "membrane";        ///< St Venant–Kirchhoff's, with the real tip
inline constexpr const char* fitted_third_order = "third-order";  ///< S = E·h E + D E²
inline constexpr const char* fitted_sheet = "sheet";              ///< a potential's own law, with bending

/// The fit against the depth up to which points are used.
struct WindowScan {
  std::vector<double> depth_max_A, Eh_eV_per_A2, pretension_eV_per_A2;
};

void describe(SameStruct<WindowScan> auto& scan, auto&& visit) {
  visit(Column{"depth_max", unit::length, "largest depth fitted"}, scan.depth_max_A);
  visit(Column{"Eh", unit::membrane_force, "sheet modulus of that fit"}, scan.Eh_eV_per_A2);
  visit(Column{"pretension", unit::membrane_force, "pretension of that fit"}, scan.pretension_eV_per_A2);
}

struct Fit {
  std::string model;  ///< name of a closed form, or of a continuum (above)
  double Eh_eV_per_A2 = not_known, Eh_stderr_eV_per_A2 = not_known;
  double pretension_eV_per_A2 = not_known, pretension_stderr_eV_per_A2 = not_known;
  std::array<double, 2> Eh_interval_eV_per_A2{not_known, not_known};
  std::array<double, 2> pretension_interval_eV_per_A2{not_known, not_known};
  double correlation = not_known;
  std::vector<ErrorSource> sources;  ///< of the standard errors, largest first
  double rms_relative = not_known;   ///< misfit: root mean square residual over the largest force
  std::array<double, 2> window_A{not_known, not_known};
  int points = 0;
  double chi2_per_dof = not_known;  ///< where the noise is known from elsewhere
  double runs_z = not_known;  ///< signs of the residuals along the depth: standard errors fewer changes than chance
  std::optional<double> contact_nm, contact_stderr_nm, force_zero_nN, force_zero_stderr_nN, slope_nN_per_nm;
  std::optional<double> sigma_force_nN, sigma_depth_nm;  ///< noise, as given or as found
  double minus_two_log_likelihood = not_known;           ///< of the points, for models fitted to the same points
  std::optional<double> Eh_bootstrap_eV_per_A2, pretension_bootstrap_eV_per_A2;  ///< standard errors, where asked for
  std::optional<double> torn_at_A;                        ///< the continuum fitted ends here, and the fit with it
  std::vector<double> fitted_depth_A, residual_eV_per_A;  ///< the points fitted, force − model
  std::vector<double> model_force_eV_per_A;               ///< of the model at those depths
  std::optional<FitBias> bias;
  WindowScan scan;
  bool recommended = false;           ///< of the fits of a curve, the one to quote
  std::vector<std::string> warnings;  ///< what a careful reader would say of this fit
};

void describe(SameStruct<Fit> auto& fit, auto&& visit) {
  visit(Field{"model", unit::none, "closed form by its name; membrane, third-order or sheet: that continuum itself"},
        fit.model);
  visit(Field{"recommended", unit::none, "the fit to quote, among those of this curve"}, fit.recommended);
  visit(Field{"Eh", unit::membrane_force, "fitted sheet modulus"}, fit.Eh_eV_per_A2);
  visit(Field{"Eh_stderr", unit::membrane_force, "its standard error, all sources"}, fit.Eh_stderr_eV_per_A2);
  visit(Field{"Eh_interval", unit::membrane_force, "95 % interval, all sources"}, fit.Eh_interval_eV_per_A2);
  visit(Field{"pretension", unit::membrane_force, "fitted pretension"}, fit.pretension_eV_per_A2);
  visit(Field{"pretension_stderr", unit::membrane_force, "its standard error, all sources"},
        fit.pretension_stderr_eV_per_A2);
  visit(Field{"pretension_interval", unit::membrane_force, "95 % interval, all sources"},
        fit.pretension_interval_eV_per_A2);
  visit(Field{"correlation", unit::none, "of E·h and pretension"}, fit.correlation);
  visit(Field{"sources", unit::none, "what the standard errors come from, largest first"}, fit.sources);
  visit(Field{"rms_relative", unit::none, "misfit: rms residual / largest force; no uncertainty"}, fit.rms_relative);
  visit(Field{"window", unit::length, "smallest and largest depth fitted"}, fit.window_A);
  visit(Field{"points", unit::none, "number of points fitted", {.low = fewest_points_to_fit, .low_open = false}},
        fit.points);
  visit(Field{"chi2_per_dof", unit::none, "χ² per degree of freedom, where the noise is known"}.where_known(),
        fit.chi2_per_dof);
  visit(Field{"runs_z", unit::none, "order in the residuals: standard errors by which their sign changes too seldom"}
            .where_known(),
        fit.runs_z);
  visit(Field{"contact", unit::nanometre, "depth of the contact, fitted"}.where_known(), fit.contact_nm);
  visit(Field{"contact_stderr", unit::nanometre, "its standard error"}.where_known(), fit.contact_stderr_nm);
  visit(Field{"force_zero", unit::nanonewton, "zero of force, fitted"}.where_known(), fit.force_zero_nN);
  visit(Field{"force_zero_stderr", unit::nanonewton, "its standard error"}.where_known(), fit.force_zero_stderr_nN);
  visit(Field{"slope", unit::newton_per_metre, "of the baseline, fitted"}.where_known(), fit.slope_nN_per_nm);
  visit(Field{"sigma_force", unit::nanonewton, "noise of the forces, given or found"}.where_known(),
        fit.sigma_force_nN);
  visit(Field{"sigma_depth", unit::nanometre, "noise of the depths, given or found"}.where_known(), fit.sigma_depth_nm);
  visit(Field{"minus_two_log_likelihood", unit::none, "compares models fitted to the same points"}.where_known(),
        fit.minus_two_log_likelihood);
  visit(Field{"Eh_bootstrap", unit::membrane_force, "standard error from refits to drawn noise"}.where_known(),
        fit.Eh_bootstrap_eV_per_A2);
  visit(Field{"pretension_bootstrap", unit::membrane_force, "standard error from refits to drawn noise"}.where_known(),
        fit.pretension_bootstrap_eV_per_A2);
  visit(
      Field{"torn_at", unit::length, "the law of the continuum ends at this depth, and the fit with it"}.where_known(),
      fit.torn_at_A);
  visit(Column{"fitted_depth", unit::length, "depths of the points fitted"}.where_known(), fit.fitted_depth_A);
  visit(Column{"residual", unit::force, "force minus the fitted curve there"}.where_known(), fit.residual_eV_per_A);
  visit(Column{"model_force", unit::force, "force of the fitted curve there"}.where_known(), fit.model_force_eV_per_A);
  visit(Field{"bias", unit::none, "what this model reads from a continuum that is known"}.where_known(), fit.bias);
  visit(Field{"window_scan", unit::none, "this fit against the depth up to which it goes"}, fit.scan);
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

/// The fit to quote; null where there is none.
inline const Fit* recommended_fit(const std::vector<Fit>& fits) {
  const auto found = std::ranges::find_if(fits, &Fit::recommended);
  return found == fits.end() ? nullptr : &*found;
}

}  // namespace validate
