// E·h and pretension against the window of the fit, as gnuplot commands.
#pragma once

#include <string>
#include <vector>

#include "compare/results/result.hpp"

namespace validate {

/// A curve's scan with its name; NaN where there is no known value to compare with.
struct NamedScan {
  std::string name;
  const WindowScan& scan;
  double Eh_known_eV_per_A2 = not_known, pretension_known_eV_per_A2 = not_known;
};

/// Two panels side by side: E·h and pretension (N/m) against the largest depth fitted (Å, or nm above 100 Å);
/// known values as thin lines.
std::string scan_commands(const std::vector<NamedScan>& scans);

/// The same for the atoms and the like-for-like (or given) membranes of a run; empty where nothing is fitted.
std::string scan_commands(const Result& result);

}  // namespace validate
