#include "compare/documents/texts/nanite_model.hpp"

#include <fmt/format.h>

#include <iterator>

namespace validate {
namespace {

constexpr const char* functions = R"PY(

def _weights(values, first, step, count):
    """Places in a table of equal steps: the first of four neighbours, and the weights of Lagrange's cubic through them."""
    place = (np.asarray(values, dtype=float) - first) / step
    start = np.clip(np.floor(place).astype(int) - 1, 0, count - 4)
    t = place - start
    return start, ((t - 1) * (t - 2) * (t - 3) / -6, t * (t - 2) * (t - 3) / 2, t * (t - 1) * (t - 3) / -2,
                   t * (t - 1) * (t - 2) / 6)


def sheet_force(depth, Eh, pretension):
    """Force in N at depths > 0 in m, for E h > 0 and a pretension >= 0 in N/m."""
    v = min(np.log1p(max(pretension / Eh, 0.0) / SCALE), STEP_V * (len(LOG_FORCE) - 1))
    start, weights = _weights(v, 0.0, STEP_V, len(LOG_FORCE))
    row = sum(w * LOG_FORCE[start + i] for i, w in enumerate(weights))
    share = np.log(np.asarray(depth, dtype=float) / RADIUS)
    last = FIRST + STEP * (len(row) - 1)
    inside = np.clip(share, FIRST, last)
    start, weights = _weights(inside, FIRST, STEP, len(row))
    log_force = sum(w * row[start + i] for i, w in enumerate(weights))
    # Beyond the table as a power law: a line before it, a cube behind it.
    return Eh * RADIUS * np.exp(log_force + np.minimum(share - FIRST, 0) + 3 * np.maximum(share - last, 0))


def get_parameter_defaults():
    """The parameters in the order of parameter_keys."""
    import lmfit
    parameters = lmfit.Parameters()
    parameters.add("Eh", value=340.0, min=1e-3)
    parameters.add("pretension", value=0.1, min=0)
    parameters.add("contact_point", value=0)
    parameters.add("baseline", value=0)
    return parameters


def suspended_sheet(delta, Eh, pretension, contact_point=0, baseline=0):
    """A suspended sheet that is clamped at its rim, pressed in its middle: the membrane of finite strain with its real tip.

    delta: tip position in m, falling into the sheet; Eh and pretension in N/m; contact_point in m; baseline in N.
    The force in N.
    """
    delta = np.asarray(delta, dtype=float)
    depth = contact_point - delta
    force = np.zeros_like(delta)
    pressed = depth > 0
    force[pressed] = sheet_force(depth[pressed], Eh, pretension)
    return force + baseline


model_doc = suspended_sheet.__doc__
model_func = suspended_sheet
model_key = "suspended_sheet"
model_name = "suspended sheet (finite strain, real tip)"
parameter_keys = ["Eh", "pretension", "contact_point", "baseline"]
parameter_names = ["Sheet Modulus", "Pretension", "Contact Point", "Force Baseline"]
parameter_units = ["N/m", "N/m", "m", "N"]
valid_axes_x = ["tip position"]
valid_axes_y = ["force"]
)PY";

}  // namespace

std::string nanite_model(const SheetForces& sheet, const std::string& command_line) {
  std::string text = fmt::format(
      "\"\"\"A suspended sheet as a model of nanite and PyJibe.\n\nradius {:g} m, nu {:g}, tip: {} of {:g} m; forces "
      "to "
      "{:.1g} of the largest.\nMade by: {}\n\"\"\"\nimport numpy as np\n\n"
      "RADIUS = {:.12g}  # m\nFIRST, STEP = {:.12g}, {:.12g}  # of ln(depth / RADIUS)\n"
      "SCALE, STEP_V = {:.12g}, {:.12g}  # of ln(1 + pretension / Eh / SCALE), from 0\n"
      "# ln(F / (Eh RADIUS)): a row for each pretension, over the depths\nLOG_FORCE = np.array([\n",
      sheet.radius_m, sheet.nu, sheet.tip, sheet.tip_radius_m, sheet.relative_error, command_line, sheet.radius_m,
      sheet.first_log_depth, sheet.step_log_depth, sheet.scale, sheet.step_v);
  for (const std::vector<double>& row : sheet.log_force) {
    text += "    [";
    for (std::size_t i = 0; i < row.size(); ++i) {
      constexpr std::size_t per_line = 10;
      const char* separator = i == 0 ? "" : i % per_line == 0 ? ",\n     " : ", ";
      fmt::format_to(std::back_inserter(text), "{}{:.8f}", separator, row[i]);
    }
    text += "],\n";
  }
  return text + "])\n" + functions;
}

}  // namespace validate
