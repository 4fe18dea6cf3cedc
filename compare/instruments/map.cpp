#include "compare/instruments/map.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace validate {
namespace {

/// Equally spaced places along one direction.
struct Spacing {
  double low = 0, step = 0;
  int count = 0;
};

std::optional<Spacing> spacing_of(std::vector<double> places) {
  std::ranges::sort(places);
  const double width = places.back() - places.front();
  if (!(width > 0)) return std::nullopt;
  std::vector<double> different = {places.front()};
  for (const double place : places)
    if (place - different.back() > 1e-3 * width) different.push_back(place);
  const double step = width / static_cast<double>(different.size() - 1);
  for (std::size_t i = 0; i < different.size(); ++i)
    if (std::abs(different[i] - different.front() - static_cast<double>(i) * step) > 0.05 * step) return std::nullopt;
  return Spacing{places.front(), step, static_cast<int>(different.size())};
}

}  // namespace

void number_as_map(std::vector<Recording>& recordings) {
  std::set<int> numbers;
  std::vector<double> x, y;
  for (const Recording& recording : recordings) {
    numbers.insert(recording.index);
    x.push_back(recording.metadata.position_x_m);
    y.push_back(recording.metadata.position_y_m);
  }
  if (numbers.size() < recordings.size())
    for (std::size_t i = 0; i < recordings.size(); ++i) recordings[i].index = static_cast<int>(i);
  if (recordings.size() < 4 || std::ranges::any_of(x, [](double v) { return !std::isfinite(v); }) ||
      std::ranges::any_of(y, [](double v) { return !std::isfinite(v); }))
    return;
  const auto across = spacing_of(x), along = spacing_of(y);
  if (!across || !along) return;
  for (Recording& recording : recordings) {
    RecordingMetadata& m = recording.metadata;
    m.grid_shape_x = across->count;
    m.grid_shape_y = along->count;
    m.grid_size_x_m = across->count * across->step;
    m.grid_size_y_m = along->count * along->step;
    m.grid_center_x_m = across->low + 0.5 * (across->count - 1) * across->step;
    m.grid_center_y_m = along->low + 0.5 * (along->count - 1) * along->step;
    m.grid_index_x = static_cast<int>(std::lround((m.position_x_m - across->low) / across->step));
    m.grid_index_y = static_cast<int>(std::lround((m.position_y_m - along->low) / along->step));
  }
}

}  // namespace validate
