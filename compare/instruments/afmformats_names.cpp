#include "compare/instruments/afmformats_names.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "compare/base/errors.hpp"
#include "compare/instruments/assemble.hpp"
#include "compare/instruments/text.hpp"

namespace validate {
namespace {

template <class Set>
void at_name(RecordingMetadata& metadata, std::string_view name, Set&& set) {
  bool found = false;
  describe(metadata, [&](const Field& field, auto& member) {
    std::string spoken(field.name);
    std::ranges::replace(spoken, '_', ' ');
    if (found || spoken != name || name == "format" || name == "point count") return;
    found = true;
    set(member);
  });
}

using Kinds = std::vector<SegmentKind>;

Kinds kinds_of(std::size_t count) {
  using enum SegmentKind;
  static const std::array<Kinds, 5> kinds = {Kinds{}, Kinds{approach}, Kinds{approach, retract},
                                             Kinds{approach, pause, retract}, Kinds{pause, approach, pause, retract}};
  return count < kinds.size() ? kinds[count] : Kinds{};
}

/// Index behind the point where x turns back; its size where it does not: the way back is shorter than a fifth of the
/// way there, or than a few points.
std::size_t turn_of(const std::vector<double>& x) {
  constexpr std::size_t few = 5;
  constexpr double share = 0.2;
  const auto finite = [](double value) { return std::isfinite(value); };
  const auto first = std::ranges::find_if(x, finite);
  const auto last = std::find_if(x.rbegin(), x.rend(), finite);
  if (first == x.end()) return x.size();
  std::size_t turn = 0;
  double farthest = -1;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (std::abs(x[i] - *first) > farthest) farthest = std::abs(x[i] - *first), turn = i + 1;
  const double back = std::abs(x[turn - 1] - *last);
  return back > share * farthest && turn >= few && x.size() - turn >= few ? turn : x.size();
}

/// In lower case with blanks: springConstant, spring_constant_N_per_m, k and InvOLS are names of the same two things.
std::string plain_name(std::string_view name) {
  std::string plain;
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z' && !plain.empty() && plain.back() >= 'a' && plain.back() <= 'z') plain += ' ';
    plain += c == '_' || c == '-' ? ' ' : c;
  }
  plain = lower_case(plain);
  for (const std::string_view unit : {" n per m", " m per v", " m per a", " m per s", " hz", " s", " m"})
    if (plain.ends_with(unit)) {
      plain = plain.substr(0, plain.size() - unit.size());
      break;
    }
  if (plain == "k" || plain == "cantilever k" || plain == "springconstant") return "spring constant";
  if (plain == "inv ols" || plain == "invols" || plain == "deflection sensitivity") return "sensitivity";
  if (plain == "xposition" || plain == "x position") return "position x";
  if (plain == "yposition" || plain == "y position") return "position y";
  return plain;
}

}  // namespace

void set_metadata(RecordingMetadata& metadata, std::string_view name, double value) {
  at_name(metadata, name, [value](auto& member) {
    using Member = std::remove_cvref_t<decltype(member)>;
    if constexpr (std::is_same_v<Member, double>) member = value;
    if constexpr (std::is_same_v<Member, std::optional<int>>)
      if (std::abs(value) < 2e9) member = static_cast<int>(value);
    if constexpr (std::is_same_v<Member, std::string>) member = fmt::format("{}", value);
  });
  if (name == "setpoint") metadata.setpoint_unit = "N";
}

void set_metadata(RecordingMetadata& metadata, std::string_view name, const std::string& value) {
  at_name(metadata, name, [&value](auto& member) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(member)>, std::string>) member = value;
  });
}

void set_metadata_from_text(RecordingMetadata& metadata, std::string_view name, std::string_view text) {
  const std::string plain = plain_name(name);
  const std::string_view content = trimmed(text);
  const auto end = content.find_first_not_of("0123456789.+-eE");
  const auto number = number_of(content.substr(0, end));
  if (!number || (plain == "date" || plain == "time")) return set_metadata(metadata, plain, std::string(content));
  const auto unit = end == std::string_view::npos ? std::nullopt : si_unit(content.substr(end));
  if (end != std::string_view::npos && !unit) return;
  set_metadata(metadata, plain, *number * (unit ? unit->factor : 1));
  set_metadata(metadata, plain, std::string(content));  // the digits of a version are no number's
}

std::vector<RecordedSegment> numbered_segments(const std::vector<double>& numbers, const std::string& label) {
  std::vector<RecordedSegment> segments;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i == 0 || numbers[i] != numbers[i - 1]) segments.emplace_back();
    ++segments.back().points;
    if (segments.size() > 4)
      throw bad_input(
          "{}: column segment: more than four segments, the fifth from point {} on; allowed: 1 to 4, "
          "each numbered by one value",
          label, i);
  }
  const Kinds kinds = kinds_of(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) segments[i].kind = kinds[i];
  return segments;
}

void split_at_turn(Recording& recording) {
  const RecordedColumns& c = recording.columns;
  const auto* x = c.height_piezo      ? &*c.height_piezo
                  : c.height_measured ? &*c.height_measured
                  : c.depth           ? &*c.depth
                  : c.tip_position    ? &*c.tip_position
                  : c.deflection      ? &*c.deflection
                                      : nullptr;
  std::size_t points = 0;
  describe(c, [&](const Field&, const std::optional<RecordedColumn>& column) {
    if (column) points = column->values.size();
  });
  if (points == 0 && !recording.other_columns.empty()) points = recording.other_columns.front().values.size();
  const std::size_t turn = x ? turn_of(x->values) : points;
  recording.segments = approach_and_retract(turn, points);
  recording.metadata.points = static_cast<int>(points);
  if (recording.segments.size() == 2)
    recording.notes.push_back(
        fmt::format("approach and retract are told apart where the height or depth turns, behind point {}", turn));
}

}  // namespace validate
