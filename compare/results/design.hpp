// What an experiment that is planned will tell.
#pragma once

#include <string>
#include <vector>

#include "compare/base/describe.hpp"
#include "compare/results/fit.hpp"
#include "compare/results/known.hpp"

namespace validate {

/// An experiment, and the standard errors that its noise and its uncertain inputs make.
struct DesignRow {
  std::string what;  ///< as asked for, or what is changed
  double radius_A = not_known, tip_radius_A = not_known, spring_constant_eV_per_A2 = not_known;
  double depth_A = not_known, force_eV_per_A = not_known, noise_eV_per_A = not_known;
  int points = 0, curves = 1;
  double Eh_stderr_relative = not_known;
  double Eh_stderr_eV_per_A2 = not_known, pretension_stderr_eV_per_A2 = not_known;
  std::vector<ErrorSource> sources;
  bool reaches = false;  ///< the target
};

void describe(SameStruct<DesignRow> auto& d, auto&& visit) {
  visit(Field{"what", unit::none, "as asked for, or what is changed"}, d.what);
  visit(Field{"radius", unit::length, "of the drum"}, d.radius_A);
  visit(Field{"tip_radius", unit::length, "of the tip"}, d.tip_radius_A);
  visit(Field{"spring_constant", unit::membrane_force, "of the cantilever"}, d.spring_constant_eV_per_A2);
  visit(Field{"depth", unit::length, "largest"}, d.depth_A);
  visit(Field{"force", unit::force, "there"}, d.force_eV_per_A);
  visit(Field{"noise", unit::force, "of the force, one standard deviation"}, d.noise_eV_per_A);
  visit(Field{"points", unit::none, "of a curve"}, d.points);
  visit(Field{"curves", unit::none, "of one drum"}, d.curves);
  visit(Field{"Eh_stderr_relative", unit::none, "expected standard error of E·h over E·h"}, d.Eh_stderr_relative);
  visit(Field{"Eh_stderr", unit::membrane_force, "the same"}, d.Eh_stderr_eV_per_A2);
  visit(Field{"pretension_stderr", unit::membrane_force, "expected standard error of the pretension"},
        d.pretension_stderr_eV_per_A2);
  visit(Field{"sources", unit::none, "what they come from, largest first"}, d.sources);
  visit(Field{"reaches", unit::none, "whether the target is reached"}, d.reaches);
}

struct Design {
  double Eh_eV_per_A2 = not_known, pretension_eV_per_A2 = not_known, nu = not_known;
  double target_relative = not_known;
  std::vector<DesignRow> rows;  ///< the first as asked for
};

void describe(SameStruct<Design> auto& d, auto&& visit) {
  visit(Field{"Eh", unit::membrane_force, "of the sheet that is expected"}, d.Eh_eV_per_A2);
  visit(Field{"pretension", unit::membrane_force, "of the sheet that is expected"}, d.pretension_eV_per_A2);
  visit(Field{"nu", unit::none, "Poisson's ratio"}, d.nu);
  visit(Field{"target", unit::none, "standard error of E·h over E·h that is wanted"}.where_known(), d.target_relative);
  visit(Field{"rows", unit::none, "the experiment asked for, then each with one thing changed"}, d.rows);
}

}  // namespace validate
