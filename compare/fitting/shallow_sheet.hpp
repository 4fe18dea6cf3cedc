// The shallow sheet under its tip, to which a table takes the finite-strain sheet's forces.
#pragma once

#include <memory>
#include <optional>

#include "compare/fitting/even_spline.hpp"
#include "compare/fitting/force_model.hpp"
#include "compare/fitting/models/foeppl.hpp"
#include "compare/fitting/models/list.hpp"
#include "compare/fitting/sheet_physics.hpp"

namespace validate {

/// Föppl's disc, or for a sphere the sum of its limits; and a plate, which neither parameter changes. Homogeneous in
/// E·h and pretension but for that.
class ShallowSheet {
 public:
  ShallowSheet(const MembraneTip& tip, double deepest_A);

  /// Force (eV/Å) at a depth > 0 (Å).
  double force(double d, double Eh, double pretension) const { return along(d, Eh, pretension).value.force; }
  ForceAlong along(double d, double Eh, double pretension) const;

 private:
  struct Sphere {
    EvenSteps steps;  ///< of ln d
    EvenSpline line;  ///< of the pretension's share over the depth
  };

  void tabulate_sphere(const AnyCurveModel& form, double deepest);
  ForceAlong of_sphere(double d, double Eh, double pretension) const;
  ForceAlong of_disc(double d, double Eh, double pretension) const;

  double a_, plate_ = 0;
  std::shared_ptr<const FoepplCurve> foeppl_;
  std::optional<Sphere> sphere_;
};

}  // namespace validate
