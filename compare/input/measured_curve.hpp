// A measured force–depth curve as a fit takes it.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compare/input/preparation.hpp"

namespace validate {

struct MeasuredCurve {
  std::filesystem::path file;
  std::string source;                ///< the file alone, where `file` names the curve in it too
  int index = 0;                     ///< of the curve in it
  std::optional<double> x_nm, y_nm;  ///< its place; NaN or absent: not known
  std::vector<double> depth_A, force_eV_per_A;
  std::vector<double> sigma_eV_per_A;  ///< standard deviation of each force; empty where there is no such column
  std::vector<double> sigma_depth_A;   ///< the same of each depth
  bool depth_from_height = false;      ///< `depth_A` is the height z of the cantilever's base: depth = z − F/k
  bool zeros_unknown = false;          ///< of an instrument: its heights begin anywhere, its deflection has an offset
  std::optional<double> spring_constant_eV_per_A2;  ///< that the file itself has
  std::optional<CurvePreparation> preparation;      ///< where signs, zeros and baseline were looked for
  std::string depth_column, force_column, sigma_column;
  std::map<std::string, std::string> remarks;  ///< lines `# key: value`
  std::vector<std::string> notes;              ///< what was done to the file's numbers
};

/// Which columns to read: a header cell, its name without the unit, or a number from 1. Empty: found by name.
struct ColumnChoice {
  std::string depth, force, sigma;
};

}  // namespace validate
