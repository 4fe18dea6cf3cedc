// A measured force–depth curve: a CSV file with units in its header.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace validate {

struct MeasuredCurve {
  std::filesystem::path file;
  std::vector<double> depth_A, force_eV_per_A;
  std::vector<double> sigma_eV_per_A;  ///< standard deviation of each force; empty where there is no such column
  std::vector<double> sigma_depth_A;   ///< the same of each depth
  bool depth_from_height = false;      ///< `depth_A` is the height z of the cantilever's base: depth = z − F/k
  std::string depth_column, force_column, sigma_column;
  std::map<std::string, std::string> remarks;  ///< lines `# key: value`
};

/// Which columns to read: a header cell, its name without the unit, or a number from 1. Empty: found by name.
struct ColumnChoice {
  std::string depth, force, sigma;
};

/// Reads a table separated by commas, semicolons or tabs. Lines that start with # are remarks; the first
/// other line is the header, whose cells end in a unit: depth_nm, force_nN, "depth (nm)", "force [nN]",
/// force_eV_per_A. Columns are recognised as depth, indentation, displacement or deflection, else as height, z or
/// piezo; force or load; sigma, error or stddev; sigma_depth or depth_error. Throws Error: bad input with file, line
/// and what is expected; file failed if the file cannot be read.
MeasuredCurve read_measured(const std::filesystem::path& file, const ColumnChoice& choice);

}  // namespace validate
