#include "reference/sheet_curves.hpp"

#include <cmath>

#include "reference/svk_disc.hpp"
#include "reference/svk_sphere.hpp"

namespace reference {
namespace {

double force_of(const SheetCurve& curve, double depth) {
  const SvkSheet sheet{drum_Eh_N_per_m, drum_nu, curve.pretension_N_per_m};
  if (curve.tip == "sphere") return svk_sphere_at_depth({sheet, drum_radius_nm, curve.tip_radius_nm}, depth).force;
  return svk_disc_at_depth({sheet, drum_radius_nm, curve.tip_radius_nm}, depth).force;
}

}  // namespace

std::vector<SheetCurve> sheet_curves(int every) {
  constexpr int depths = 60;
  constexpr double first = 0.05, last = 110;
  std::vector<SheetCurve> curves;
  for (const auto& [tip, radius] : {std::pair("disc", 16.5), {"disc", 2.0}, {"sphere", 16.5}})
    for (const double pretension : {0.1, 0.34, 0.7}) {
      SheetCurve curve{tip, radius, pretension, {}, {}};
      for (int i = 0; i < depths; i += every) {
        curve.depth_nm.push_back(first * std::pow(last / first, i / (depths - 1.0)));
        curve.force_nN.push_back(force_of(curve, curve.depth_nm.back()));
      }
      curves.push_back(std::move(curve));
    }
  return curves;
}

}  // namespace reference
