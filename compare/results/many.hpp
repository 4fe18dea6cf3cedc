// Many measured curves: one row each, and what they say together.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "compare/base/describe.hpp"
#include "compare/results/known.hpp"

namespace validate {

/// One curve of many. A curve that is not used has its reason, and of the rest what is known.
struct CurveRow {
  std::string file;
  int index = 0;        ///< in its file
  std::string skipped;  ///< why it is not used; empty: it is
  std::string model;    ///< of the fit that is quoted
  double x_nm = not_known, y_nm = not_known;
  double Eh_eV_per_A2 = not_known, Eh_stderr_eV_per_A2 = not_known;
  double Eh_low_eV_per_A2 = not_known, Eh_high_eV_per_A2 = not_known;
  double Eh_noise_eV_per_A2 = not_known;
  double pretension_eV_per_A2 = not_known, pretension_stderr_eV_per_A2 = not_known;
  double pretension_low_eV_per_A2 = not_known, pretension_high_eV_per_A2 = not_known;
  double height_A = not_known;
  double contact_nm = not_known, force_zero_nN = not_known, slope_N_per_m = not_known;
  double sigma_force_nN = not_known, sigma_depth_nm = not_known;
  double deepest_A = not_known, largest_force_eV_per_A = not_known;
  double chi2_per_dof = not_known, rms_relative = not_known, runs_z = not_known;
  double pull_off_eV_per_A = not_known, pull_off_work_eV = not_known;
  int points = 0;
};

namespace detail {

template <class Self, class Visitor>
void describe_fitted(Self& r, Visitor&& visit) {
  visit(Field{"Eh", unit::membrane_force, "sheet modulus"}.where_known(), r.Eh_eV_per_A2);
  visit(Field{"Eh_stderr", unit::membrane_force, "its standard error, all sources"}.where_known(),
        r.Eh_stderr_eV_per_A2);
  visit(Field{"Eh_low", unit::membrane_force, "lower end of its 95 % interval"}.where_known(), r.Eh_low_eV_per_A2);
  visit(Field{"Eh_high", unit::membrane_force, "upper end"}.where_known(), r.Eh_high_eV_per_A2);
  visit(Field{"Eh_noise", unit::membrane_force, "standard error by this curve's noise alone"}.where_known(),
        r.Eh_noise_eV_per_A2);
  visit(Field{"pretension", unit::membrane_force, "pretension"}.where_known(), r.pretension_eV_per_A2);
  visit(Field{"pretension_stderr", unit::membrane_force, "its standard error"}.where_known(),
        r.pretension_stderr_eV_per_A2);
  visit(Field{"pretension_low", unit::membrane_force, "lower end of its 95 % interval"}.where_known(),
        r.pretension_low_eV_per_A2);
  visit(Field{"pretension_high", unit::membrane_force, "upper end"}.where_known(), r.pretension_high_eV_per_A2);
  visit(Field{"contact", unit::nanometre, "depth of the contact, fitted"}.where_known(), r.contact_nm);
  visit(Field{"force_zero", unit::nanonewton, "zero of force, fitted"}.where_known(), r.force_zero_nN);
  visit(Field{"slope", unit::newton_per_metre, "of the baseline, fitted"}.where_known(), r.slope_N_per_m);
  visit(Field{"sigma_force", unit::nanonewton, "noise of the forces"}.where_known(), r.sigma_force_nN);
  visit(Field{"sigma_depth", unit::nanometre, "noise of the depths"}.where_known(), r.sigma_depth_nm);
  visit(Field{"deepest", unit::length, "largest depth"}.where_known(), r.deepest_A);
  visit(Field{"largest_force", unit::force, "of the points fitted"}.where_known(), r.largest_force_eV_per_A);
  visit(Field{"chi2_per_dof", unit::none, "where the noise is known"}.where_known(), r.chi2_per_dof);
  visit(Field{"rms_relative", unit::none, "rms residual over the largest force"}.where_known(), r.rms_relative);
  visit(Field{"runs_z", unit::none, "order in the residuals, in standard errors"}.where_known(), r.runs_z);
}

}  // namespace detail

void describe(SameStruct<CurveRow> auto& r, auto&& visit) {
  visit(Field{"file", unit::none, "that was read"}, r.file);
  visit(Field{"index", unit::none, "of the curve in it"}, r.index);
  visit(Field{"skipped", unit::none, "why it is not used"}.where_known(), r.skipped);
  visit(Field{"model", unit::none, "of the fit that is quoted"}.where_known(), r.model);
  visit(Field{"x", unit::nanometre, "place of the curve"}.where_known(), r.x_nm);
  visit(Field{"y", unit::nanometre, "place of the curve"}.where_known(), r.y_nm);
  visit(Field{"height", unit::length, "at which the sheet is touched, of the file"}.where_known(), r.height_A);
  visit(Field{"points", unit::none, "number of points fitted"}, r.points);
  detail::describe_fitted(r, visit);
  visit(Field{"pull_off", unit::force, "largest adhesion on the way back"}.where_known(), r.pull_off_eV_per_A);
  visit(Field{"pull_off_work", unit::energy, "of the adhesion"}.where_known(), r.pull_off_work_eV);
}

/// What an error of the joint E·h comes from.
struct JointSource {
  std::string name;
  double Eh_eV_per_A2 = 0;
  bool falls = false;
};

void describe(SameStruct<JointSource> auto& s, auto&& visit) {
  visit(Field{"name", unit::none, "noise, or the input that is uncertain"}, s.name);
  visit(Field{"Eh", unit::membrane_force, "standard error of the joint E·h from this source alone"}, s.Eh_eV_per_A2);
  visit(Field{"falls", unit::none, "whether more curves like these make it smaller"}, s.falls);
}

/// One E·h for all curves, everything else their own, errors of the calibration shared.
struct JointFit {
  double Eh_eV_per_A2 = not_known, Eh_stderr_eV_per_A2 = not_known;
  std::array<double, 2> Eh_interval_eV_per_A2{not_known, not_known};
  int curves = 0, drums = 0;
  double chi2_per_dof = not_known;  ///< of the curves' own E·h about it, by their noise
  std::vector<JointSource> sources;
};

void describe(SameStruct<JointFit> auto& j, auto&& visit) {
  visit(Field{"Eh", unit::membrane_force, "one for all curves"}, j.Eh_eV_per_A2);
  visit(Field{"Eh_stderr", unit::membrane_force, "its standard error, all sources"}, j.Eh_stderr_eV_per_A2);
  visit(Field{"Eh_interval", unit::membrane_force, "95 % interval, all sources"}, j.Eh_interval_eV_per_A2);
  visit(Field{"curves", unit::none, "that it is fitted to"}, j.curves);
  visit(Field{"drums", unit::none, "files, each a drum"}, j.drums);
  visit(
      Field{"chi2_per_dof", unit::none, "scatter of the curves' own E·h about it, by their noise alone"}.where_known(),
      j.chi2_per_dof);
  visit(Field{"sources", unit::none, "what its error comes from, largest first"}, j.sources);
}

/// A mean over values that scatter more than their errors say: normal, variance τ² + σ_i².
struct SpreadMean {
  std::string of;  ///< curves, drums
  int count = 0;
  double Eh_eV_per_A2 = not_known, Eh_stderr_eV_per_A2 = not_known;
  double Eh_within_eV_per_A2 = not_known, Eh_between_eV_per_A2 = not_known;
  double pretension_eV_per_A2 = not_known, pretension_within_eV_per_A2 = not_known,
         pretension_between_eV_per_A2 = not_known;
};

void describe(SameStruct<SpreadMean> auto& m, auto&& visit) {
  visit(Field{"of", unit::none, "curves, or drums: the mean of each counts once"}, m.of);
  visit(Field{"count", unit::none, "of them"}, m.count);
  visit(Field{"Eh", unit::membrane_force, "mean"}, m.Eh_eV_per_A2);
  visit(Field{"Eh_stderr", unit::membrane_force, "its standard error without what all share"}, m.Eh_stderr_eV_per_A2);
  visit(Field{"Eh_within", unit::membrane_force, "error of one by its noise, rms"}, m.Eh_within_eV_per_A2);
  visit(Field{"Eh_between", unit::membrane_force, "spread of the true ones, standard deviation"},
        m.Eh_between_eV_per_A2);
  visit(Field{"pretension", unit::membrane_force, "mean"}, m.pretension_eV_per_A2);
  visit(Field{"pretension_within", unit::membrane_force, "error of one, rms"}, m.pretension_within_eV_per_A2);
  visit(Field{"pretension_between", unit::membrane_force, "spread of the true ones, standard deviation"},
        m.pretension_between_eV_per_A2);
}

struct ManyCurves {
  std::vector<CurveRow> rows;
  std::vector<SpreadMean> means;
  std::vector<JointFit> joint;  ///< none or one
  double wall_s = not_known;
};

void describe(SameStruct<ManyCurves> auto& m, auto&& visit) {
  visit(Field{"rows", unit::none, "one a curve"}, m.rows);
  visit(Field{"means", unit::none, "over the curves that are used"}, m.means);
  visit(Field{"joint", unit::none, "one E·h for all curves"}.where_known(), m.joint);
  visit(Field{"wall", unit::second, "time taken"}.where_known(), m.wall_s);
}

}  // namespace validate
