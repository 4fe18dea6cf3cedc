#include "compare/fitting/shallow_sheet.hpp"

#include <cmath>
#include <utility>
#include <vector>

namespace validate {

ShallowSheet::ShallowSheet(const MembraneTip& tip, double deepest_A)
    : a_(tip.a_A), foeppl_(foeppl_curve(tip.nu, tip.is_sphere() ? 0 : tip.tip_A / a_)) {
  const ModelGeometry geometry{tip.a_A, tip.nu, tip.tip_A, tip.bending_eV()};
  if (tip.is_sphere()) tabulate_sphere(closed_form("sphere-pretension", "").make(geometry), deepest_A);
  if (tip.bending_eV() > 0)
    plate_ = plate_stiffness(tip.is_sphere() ? ModelGeometry{tip.a_A, tip.nu, 0, tip.bending_eV()} : geometry);
}

ForceAlong ShallowSheet::along(double d, double Eh, double pretension) const {
  ForceAlong f = sphere_ ? of_sphere(d, Eh, pretension) : of_disc(d, Eh, pretension);
  f.value.force = Eh * f.value.by_Eh + pretension * f.value.by_pretension + plate_ * d;
  f.first.force = Eh * f.first.by_Eh + pretension * f.first.by_pretension + plate_;
  return f;
}

/// Its contact is found once for many depths.
void ShallowSheet::tabulate_sphere(const AnyCurveModel& form, double deepest) {
  constexpr int count = 300;
  const double unit[] = {1, 1}, lowest = std::log(1e-7 * deepest);
  const EvenSteps steps{lowest, (std::log(2 * deepest) - lowest) / (count - 1), count};
  std::vector<double> line;
  double gradient[2] = {};
  for (int i = 0; i < count; ++i) {
    const double d = std::exp(lowest + i * steps.step);
    form.gradient(d, unit, gradient);
    line.push_back(gradient[1] / d);
  }
  sphere_ = Sphere{steps, EvenSpline(steps, std::move(line))};
}

/// E·h α δ³/a² + σ0h δ p(ln δ)
ForceAlong ShallowSheet::of_sphere(double d, double Eh, double pretension) const {
  const SplineAlong p = sphere_->line.along(sphere_->steps.place(std::log(d)));
  const double cubic = foeppl_->alpha() / (a_ * a_);
  return {{0, cubic * d * d * d, d * p.value},
          {0, 3 * cubic * d * d, p.value + p.first},
          6 * cubic * Eh * d + pretension * (p.first + p.second) / d};
}

/// E·h δ³/a² g(η), η = σ0h a²/(E·h δ²)
ForceAlong ShallowSheet::of_disc(double d, double Eh, double pretension) const {
  const double eta = pretension * a_ * a_ / (Eh * d * d), square = d * d / (a_ * a_);
  const auto [g, slope, bend] = foeppl_->along(eta);
  const double rest = g - eta * slope, bent = 2 * eta * eta * bend;
  return {{0, square * d * rest, d * slope},
          {0, square * (3 * rest + bent), slope - 2 * eta * bend},
          Eh * d / (a_ * a_) * (6 * rest + 2 * bent)};
}

}  // namespace validate
