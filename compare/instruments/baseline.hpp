// The part of a curve before the contact: its straight line, its noise, where it ends.
#pragma once

#include <cstddef>
#include <vector>

namespace validate {

/// y = level + tilt (x − origin), through the points with the largest misses left out.
struct StraightLine {
  double origin = 0, level = 0, tilt = 0;
  double spread = 0;  ///< standard deviation of a point about it
  int points = 0;     ///< that it goes through

  double at(double x) const { return level + tilt * (x - origin); }
};

/// What stands before the contact of a curve whose points are in the order of x, growing towards the sample.
struct BeforeContact {
  StraightLine line;
  std::size_t contact = 0;      ///< first point in contact, by a first estimate
  std::size_t undisturbed = 0;  ///< the line's points come before this one
  std::size_t snap = 0;         ///< first point of an attraction before the contact; `contact` where there is none
  double attraction = 0;        ///< the largest, > 0
};

/// The line is followed from far away to where points leave it. `tilted` false: it is level. Fewer than ten points
/// before the contact give no line: points = 0.
BeforeContact before_contact(const std::vector<double>& x, const std::vector<double>& y, bool tilted);

/// Least squares with points beyond three standard deviations left out, again and again.
StraightLine robust_line(const std::vector<double>& x, const std::vector<double>& y, std::size_t from, std::size_t to,
                         bool tilted);

}  // namespace validate
