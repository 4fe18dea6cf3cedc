#include "compare/fitting/force_model.hpp"

#include <utility>

namespace validate {
namespace {

void add(ForceAt& sum, double share, const ForceAt& more) {
  sum.force += share * more.force;
  sum.by_Eh += share * more.by_Eh;
  sum.by_pretension += share * more.by_pretension;
}

/// Central differences: right to 1e-6 of the force over the depth.
ForceAlong differences(const ForceFunction& at, double depth, double Eh, double pretension) {
  const double h = 1e-3 * depth;
  const ForceAt before = at(depth - h, Eh, pretension), after = at(depth + h, Eh, pretension);
  ForceAlong along{at(depth, Eh, pretension), {}, 0};
  add(along.first, 0.5 / h, after);
  add(along.first, -0.5 / h, before);
  along.second = (after.force - 2 * along.value.force + before.force) / (h * h);
  return along;
}

}  // namespace

ForceCurve curve_of(const ForceModel& model, double Eh, double pretension) {
  if (model.curve) return model.curve(Eh, pretension);
  return [at = model.at, Eh, pretension](double depth) { return differences(at, depth, Eh, pretension); };
}

ForceModel with_forces(ForceModel model, ForceFunction at) {
  model.at = std::move(at);
  model.curve = nullptr;
  return model;
}

ForceModel force_model(AnyCurveModel closed_form) {
  return {[form = std::move(closed_form)](double depth, double Eh, double pretension) {
    const double parameters[] = {Eh, pretension};
    double gradient[2];
    form.gradient(depth, parameters, gradient);
    return ForceAt{form.value(depth, parameters), gradient[0], gradient[1]};
  }};
}

ForceModel sum_of(std::vector<std::pair<double, ForceModel>> parts) {
  ForceModel sum = parts.front().second;
  sum.at = [parts](double depth, double Eh, double pretension) {
    ForceAt all;
    for (const auto& [share, model] : parts) add(all, share, model.at(depth, Eh, pretension));
    return all;
  };
  sum.curve = [parts = std::move(parts)](double Eh, double pretension) -> ForceCurve {
    std::vector<std::pair<double, ForceCurve>> curves;
    for (const auto& [share, model] : parts) curves.emplace_back(share, curve_of(model, Eh, pretension));
    return [curves = std::move(curves)](double depth) {
      ForceAlong all;
      for (const auto& [share, curve] : curves) {
        const ForceAlong one = curve(depth);
        add(all.value, share, one.value);
        add(all.first, share, one.first);
        all.second += share * one.second;
      }
      return all;
    };
  };
  return sum;
}

ForceModel scaled(ForceModel model, double factor) { return sum_of({{factor, std::move(model)}}); }

}  // namespace validate
