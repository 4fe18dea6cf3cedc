#include "compare/documents/texts/recording_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "compare/base/keys.hpp"
#include "compare/base/walk.hpp"

namespace validate {
namespace {

/// Calls visit(key, text) for each member of the metadata that is known.
template <class Visit>
void each_metadata(const RecordingMetadata& metadata, Visit&& visit) {
  describe(metadata, [&](const Field& field, const auto& member) {
    if (lacks(member)) return;
    if constexpr (Optional<std::remove_cvref_t<decltype(member)>>)
      visit(key(field), fmt::format("{}", *member));
    else
      visit(key(field), fmt::format("{}", member));
  });
}

std::string column_line(const std::string& name, const std::string& unit, const std::vector<double>& values) {
  double low = INFINITY, high = -INFINITY;
  for (const double value : values)
    if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  if (!(low <= high)) return fmt::format("  {:<24} {:<4} no value\n", name, unit);
  return fmt::format("  {:<24} {:<4} {:>13.6g} … {:<13.6g} from {:.6g} to {:.6g}\n", name, unit, values.front(),
                     values.back(), low, high);
}

std::string cell(double value) { return std::isfinite(value) ? fmt::format("{}", value) : std::string(); }

std::string quoted(const std::string& text) {
  return text.find_first_of(",\"") == std::string::npos ? text : '"' + text + '"';
}

}  // namespace

std::string recording_text(const Recording& recording) {
  std::string text = fmt::format("{}, curve {}\n", recording.file, recording.index);
  each_metadata(recording.metadata, [&](const std::string& name, const std::string& value) {
    text += fmt::format("  {:<24} {}\n", name, value);
  });
  text += "segments\n";
  for (const RecordedSegment& segment : recording.segments) {
    text += fmt::format("  {:<24} {} points", to_string(segment.kind), segment.points);
    if (std::isfinite(segment.duration_s)) text += fmt::format(", {:g} s", segment.duration_s);
    text += "\n";
  }
  text += "columns: first … last, range\n";
  each_column(recording, [&](const std::string& name, const std::string& unit, const std::vector<double>& values) {
    text += column_line(name, unit, values);
  });
  for (const std::string& note : recording.notes) text += "note: " + note + "\n";
  return text;
}

std::string recording_csv(const Recording& recording) {
  std::string text = fmt::format("# file: {}\n# index: {}\n", recording.file, recording.index);
  each_metadata(recording.metadata, [&](const std::string& name, std::string value) {
    std::ranges::replace(value, '\n', ' ');
    text += fmt::format("# {}: {}\n", name, value);
  });
  for (std::size_t i = 0; i < recording.segments.size(); ++i)
    text += fmt::format("# segment {}: {}\n", i, to_string(recording.segments[i].kind));
  std::string header = "segment";
  std::vector<const std::vector<double>*> columns;
  each_column(recording, [&](const std::string& name, const std::string& unit, const std::vector<double>& values) {
    header += "," + quoted(unit.empty() ? name : fmt::format("{} ({})", name, unit));
    columns.push_back(&values);
  });
  text += header + "\n";
  std::size_t row = 0;
  for (std::size_t s = 0; s < recording.segments.size(); ++s)
    for (int i = 0; i < recording.segments[s].points; ++i, ++row) {
      fmt::format_to(std::back_inserter(text), "{}", s);
      for (const auto* values : columns) text += "," + cell((*values)[row]);
      text += "\n";
    }
  return text;
}

}  // namespace validate
