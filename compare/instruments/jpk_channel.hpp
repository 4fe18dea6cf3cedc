// One channel of one segment of a JPK file: integers and what the header makes of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compare/instruments/archive.hpp"
#include "compare/instruments/properties.hpp"

namespace validate {

/// A linear scaling from one calibration slot to the next; slots form a tree.
struct JpkSlot {
  std::string name, base;  ///< base: the slot that it is made from; empty for the root
  double multiplier = 1, offset = 0;
  std::string unit;
};

class JpkChannel {
 public:
  /// `header` with its references resolved; `folder` of the segment in the archive, with its slash; `points` of the
  /// segment. Throws Error (bad input), which `label` starts, for what is missing, damaged or of an unknown kind.
  JpkChannel(const Archive& archive, const std::string& folder, const Properties& header, const std::string& name,
             int points, const std::string& label);

  /// Slots that the file defines, the base first.
  const std::vector<JpkSlot>& slots() const { return slots_; }
  const JpkSlot* slot(std::string_view name) const;

  /// Values in a slot that is there.
  std::vector<double> in(std::string_view slot) const;

 private:
  void read_slots(const Properties& header, const std::string& prefix);
  void read_values(const Archive& archive, const std::string& folder, const Properties& header,
                   const std::string& prefix);
  std::vector<double> decoded(std::string_view bytes, const std::string& encoder) const;

  int points_;
  std::string label_;
  std::vector<JpkSlot> slots_;
  std::vector<double> base_;
};

}  // namespace validate
