// An Igor binary wave, version 5, taken apart: values, labels and note.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace validate {

struct IgorWave {
  std::size_t rows = 0;
  double step = 0;                           ///< of dimension 0
  std::vector<std::string> labels;           ///< of dimension 1
  std::vector<std::vector<double>> columns;  ///< one a label
  std::string unit;                          ///< of the values
  std::string note;
};

/// Whether the checksum of the header is right, in either byte order.
bool is_igor_wave(std::string_view bytes);

/// Throws Error (bad input), which `label` starts, where sizes do not fit the file or the values are no real numbers.
IgorWave read_igor_wave(std::string_view bytes, const std::string& label);

}  // namespace validate
