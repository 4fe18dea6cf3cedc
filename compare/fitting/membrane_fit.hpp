// The membrane model itself as the curve that is fitted: E·h and pretension free, the real tip.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/results/result.hpp"
#include "membrane/laws/list.hpp"

namespace validate {

/// What a sheet is made of beside E·h and ν, where it is not the paper's membrane.
struct SheetPhysics {
  std::function<membrane::Law(double Eh_eV_per_A2)> law;  ///< a law of any sheet modulus
  double bending_eV = 0;                                  ///< κ; a sheet that bends is not relaxed
  std::string name;                                       ///< in words
  std::string model = fitted_sheet;                       ///< as Fit::model has it
};

/// The potential's own law, its stress in proportion to the sheet modulus.
SheetPhysics calibrated_physics(const membrane::CauchyBorn& law, double bending_eV, const std::string& potential);

/// Lee et al.'s law of third order: D stays when E·h changes.
SheetPhysics third_order_physics(double nu, double D_eV_per_A2, double bending_eV);

/// A clamped sheet and its tip, without E·h and pretension.
struct MembraneTip {
  double a_A = 0, nu = 0;
  double tip_A = 0;                                    ///< radius of the loaded disc or of the sphere; 0: a point
  double record_radius_A = 0;                          ///< where the depth is taken; 0: the centre
  bool sphere = false;                                 ///< rigid and frictionless; else a dead load
  std::optional<SheetPhysics> physics = std::nullopt;  ///< absent: the paper's membrane
};

struct MembraneFitReport {
  bool converged = false;
  std::string reason;  ///< why not
  int iterations = 0;  ///< curves of the membrane that were solved
  Fit fit;  ///< with the forces of the fitted sheet; `torn_at`: where a sheet that softens was last found, and beyond
            ///< which its law lets it tear: deeper points are left out
};

/// Forces (eV/Å) of a membrane at depths of record (Å). Throws std::runtime_error where the membrane is not solved.
std::vector<double> membrane_forces(const MembraneTip& tip, double Eh_eV_per_A2, double pretension_eV_per_A2,
                                    const std::vector<double>& depth_A);

struct SheetCurve {
  std::vector<double> depth_A, force_eV_per_A;
  std::string ended_early;  ///< why a depth was not reached; empty: all were
};

/// The curve of a sheet of any law at controlled depths, as far as it goes: a law that softens ends where the sheet
/// fails.
SheetCurve sheet_curve(const MembraneTip& tip, const membrane::Law& law, double pretension_eV_per_A2,
                       const std::vector<double>& depth_A);

/// Least squares with the finite-strain membrane (or the tip's sheet), solved in one dimension. A closed form (the
/// shallow membrane, or for a sphere its limits) gives the derivatives: its curve, times the ratio of the two models at
/// the last E·h and pretension, is fitted until neither changes by more than 1e-5. The ratio changes little, so few
/// curves are enough. `sigma` (eV/Å) weights the points; empty: all alike. Where the tip's own sheet ends before the
/// curve, it is fitted as far as it goes. Not converging is reported, not thrown.
MembraneFitReport fit_membrane(const MembraneTip& tip, const std::vector<double>& depth_A,
                               const std::vector<double>& force_eV_per_A, const std::vector<double>& sigma_eV_per_A);

}  // namespace validate
