// What a sheet that is fitted itself is made of, and the membrane's problem for it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/results/fit.hpp"
#include "membrane/laws/list.hpp"
#include "membrane/problem.hpp"

namespace validate {

/// What a sheet is made of beside E·h and ν, where it is not the paper's membrane.
struct SheetPhysics {
  std::function<membrane::Law(double Eh_eV_per_A2)> law;  ///< a law of any sheet modulus
  bool scales = false;                                    ///< its stresses are in proportion to the sheet modulus
  double bending_eV = 0;                                  ///< κ; a sheet that bends is not relaxed
  double slope_margin_A = 0;                              ///< by which its slope is held farther out than its rim
  std::string name;                                       ///< in words
  std::string model = fitted_sheet;                       ///< as Fit::model has it
};

/// The potential's own law, its stress in proportion to the sheet modulus.
SheetPhysics calibrated_physics(const membrane::CauchyBorn& law, double bending_eV, const std::string& potential,
                                double slope_margin_A = 0);

/// D of S = E·h E + D E² for a law under uniaxial stress: least squares over strains to 5 %, eV/Å².
double third_order_modulus(const membrane::CauchyBorn& law);

/// Lee et al.'s law of third order: D stays when E·h changes.
SheetPhysics third_order_physics(double nu, double D_eV_per_A2, double bending_eV);

/// A clamped sheet and its tip, without E·h and pretension.
struct MembraneTip {
  double a_A = 0, nu = 0;
  double tip_A = 0;                                    ///< radius of the loaded disc or of the sphere; 0: a point
  double record_radius_A = 0;                          ///< where the depth is taken; 0: the centre
  bool sphere = false;                                 ///< rigid and frictionless; else a dead load
  std::optional<SheetPhysics> physics = std::nullopt;  ///< absent: the paper's membrane

  bool is_sphere() const { return sphere && tip_A > 0; }
  double bending_eV() const { return physics ? physics->bending_eV : 0; }
};

/// On its meridian, at controlled depths (Å).
membrane::Problem problem_of(const MembraneTip& tip, const membrane::Law& law, double pretension_eV_per_A2,
                             std::vector<double> depth_A);

/// The law of the tip's sheet at a sheet modulus.
membrane::Law law_of(const MembraneTip& tip, double Eh_eV_per_A2);

struct SheetCurve {
  std::vector<double> depth_A, force_eV_per_A;
  std::string ended_early;  ///< why a depth was not reached; empty: all were
};

/// The curve of a sheet of any law at controlled depths, as far as it goes: a law that softens ends where the sheet
/// fails.
SheetCurve sheet_curve(const MembraneTip& tip, const membrane::Law& law, double pretension_eV_per_A2,
                       const std::vector<double>& depth_A);

}  // namespace validate
