// From a file of any format to curves that can be fitted: one segment, force and depth with the signs that physics asks
// for.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compare/input/measured_curve.hpp"
#include "compare/instruments/format.hpp"

namespace validate {

/// What is taken of a file, and what is known where it does not say.
struct MeasuredRequest {
  ColumnChoice columns = {};
  SegmentKind segment = SegmentKind::approach;  ///< the first of this kind
  std::optional<Baseline> baseline =
      {};  ///< to take off; absent: a tilted one of an instrument's curve, none of a table
  Calibration calibration = {};
  std::vector<int> curves = {};  ///< of a file with several these alone, by their index; empty: all
};

/// The curves of a file, read one at a time. Depths are a column of depths (a sheet's deflection, too, where there is
/// no height), else heights of the cantilever's base, else tip positions. A table's zeros and the sign of its depths
/// are kept unless a baseline is asked for; see prepare() for instruments' curves. Rows without a finite force and
/// depth are skipped. What was done stands in `notes`. For one thread at a time.
class MeasuredFile {
 public:
  /// Throws Error: bad input with file, line and what is expected; file failed if the file cannot be read.
  MeasuredFile(const std::filesystem::path& file, MeasuredRequest request);

  std::size_t size() const;
  std::string name(std::size_t i) const;  ///< for messages

  /// Nothing where the curve is not asked for. Throws Error (bad input) with file, line and what is expected.
  std::optional<MeasuredCurve> read(std::size_t i);

  /// After all were read. Throws Error (bad input) for a curve that is asked for and was not there.
  void check_all_were_there() const;

 private:
  std::filesystem::path file_;
  MeasuredRequest request_;
  std::unique_ptr<Recordings> recordings_;
  std::vector<int> there_;
};

/// Every curve of a file that is asked for. Throws as MeasuredFile does.
std::vector<MeasuredCurve> read_measured(const std::filesystem::path& file, const MeasuredRequest& request = {});

}  // namespace validate
