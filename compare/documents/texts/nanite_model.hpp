// A sheet with its tip as a model of nanite and PyJibe: one Python file that holds its forces as a table.
#pragma once

#include <string>
#include <vector>

namespace validate {

/// F/(E·h a) over ln(d/a) and v = ln(1 + s/s0), s = σ0h/(E·h), both in equal steps.
struct SheetForces {
  double radius_m = 0, nu = 0, tip_radius_m = 0;
  std::string tip;  ///< sphere, disc
  double first_log_depth = 0, step_log_depth = 0;
  double scale = 0, step_v = 0;                ///< s0; v begins at 0
  std::vector<std::vector<double>> log_force;  ///< ln F/(E·h a): a list over the depths for each v
  double relative_error = 0;                   ///< of the forces that the table was made of
};

/// The module, whose names are those that nanite asks of a model: force in N over the tip position in m.
std::string nanite_model(const SheetForces& sheet, const std::string& command_line);

}  // namespace validate
