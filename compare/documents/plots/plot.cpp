#include "compare/documents/plots/plot.hpp"

#include <algorithm>

namespace validate {

std::string axis_text(const Axis& axis) { return axis.unit.empty() ? axis.label : axis.label + " (" + axis.unit + ")"; }

bool is_map(const Panel& panel) {
  return !panel.maps.empty() ||
         std::ranges::any_of(panel.curves, [](const PlotCurve& curve) { return !curve.value.empty(); });
}

}  // namespace validate
