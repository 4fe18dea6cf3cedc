#include "compare/documents/plots/gnuplot_maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

namespace validate {
namespace {

constexpr int bands = 12;  // of equal value

struct Corner {
  Eigen::Vector3d at;
  double value = 0;
};

/// All pieces as one surface of two rows of points, between which pm3d fills the quadrilaterals; those between the
/// pieces are not numbers and stay open. A surface for each would take 9 kB of gnuplot's memory.
class PieceRows {
 public:
  void add(const std::array<Eigen::Vector3d, 4>& around, double value) {
    add(first_, around[0], around[1], value);
    add(second_, around[3], around[2], value);
  }
  std::string text() const { return first_ + "\n" + second_; }

 private:
  static void add(std::string& row, const Eigen::Vector3d& a, const Eigen::Vector3d& b, double value) {
    fmt::format_to(std::back_inserter(row),
                   "{:.6g} {:.6g} {:.6g} {:.6g}\n{:.6g} {:.6g} {:.6g} {:.6g}\nNaN NaN NaN NaN\n", a.x(), a.y(), a.z(),
                   value, b.x(), b.y(), b.z(), value);
  }
  std::string first_, second_;
};

/// Cuts a polygon at a value, which is linear between its corners, and keeps the side above it, or below.
std::vector<Corner> cut(const std::vector<Corner>& polygon, double at, bool above) {
  std::vector<Corner> kept;
  const auto inside = [&](const Corner& c) { return above ? c.value >= at : c.value <= at; };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner &here = polygon[i], &next = polygon[(i + 1) % polygon.size()];
    if (inside(here)) kept.push_back(here);
    if (inside(here) == inside(next)) continue;
    const double share = (at - here.value) / (next.value - here.value);
    kept.push_back({here.at + share * (next.at - here.at), at});
  }
  return kept;
}

/// A convex polygon as quadrilaterals from its first corner.
void add_polygon(PieceRows& rows, const std::vector<Corner>& polygon, double value) {
  for (std::size_t i = 1; i + 1 < polygon.size(); i += 2) {
    const std::size_t last = std::min(i + 2, polygon.size() - 1);
    rows.add({polygon[0].at, polygon[i].at, polygon[i + 1].at, polygon[last].at}, value);
  }
}

/// The parts of a triangle between neighbouring values of the scale, each in one colour; what is beyond the scale has
/// its end's.
void add_bands(PieceRows& rows, const std::vector<Corner>& triangle, const DataRange& range) {
  const double width = (range.high - range.low) / bands;
  const auto band_of = [&](double value) {
    return width > 0 ? std::clamp(static_cast<int>(std::floor((value - range.low) / width)), 0, bands - 1) : 0;
  };
  const auto [lowest, highest] = std::ranges::minmax(triangle, {}, &Corner::value);
  const int first = band_of(lowest.value), last = band_of(highest.value);
  for (int k = first; k <= last; ++k) {
    std::vector<Corner> part = triangle;
    if (k > first) part = cut(part, range.low + k * width, true);
    if (k < last) part = cut(part, range.low + (k + 1) * width, false);
    add_polygon(rows, part, range.low + (k + 0.5) * width);
  }
}

using Flat = std::array<Eigen::Vector2d, 3>;

/// The corner of a triangle that is none of another's, or 3 where they do not share a side.
std::size_t apart(const Flat& one, const Flat& other) {
  std::size_t found = 3;
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::ranges::find(other, one[k]) != other.end()) continue;
    if (found != 3) return 3;
    found = k;
  }
  return found;
}

std::vector<std::array<int, 2>> signs(const TriangleMap& map) {
  if (!map.quarter) return {{1, 1}};
  return {{1, 1}, {1, -1}, {-1, 1}, {-1, -1}};
}

Eigen::Vector3d corner(const TriangleMap& map, std::size_t t, std::size_t k, const std::array<int, 2>& sign) {
  return {sign[0] * map.corners[t][k].x(), sign[1] * map.corners[t][k].y(), map.height.empty() ? 0 : map.height[t][k]};
}

/// A colour a triangle; neighbours of one colour are drawn at once, which takes half the time.
void add_triangles(PieceRows& rows, const TriangleMap& map, const std::array<int, 2>& sign) {
  DataRange range;
  for (const double value : map.value) range.add(value);
  const double one_colour = (range.high - range.low) / 512;
  for (std::size_t t = 0; t < map.value.size(); ++t) {
    const auto at = [&](std::size_t k) { return corner(map, t, k % 3, sign); };
    const std::size_t next = t + 1;
    if (next < map.value.size() && std::abs(map.value[next] - map.value[t]) <= one_colour) {
      const std::size_t mine = apart(map.corners[t], map.corners[next]), its = apart(map.corners[next], map.corners[t]);
      if (mine < 3 && its < 3) {
        rows.add({at(mine), at(mine + 1), corner(map, next, its, sign), at(mine + 2)},
                 (map.value[t] + map.value[next]) / 2);
        ++t;
        continue;
      }
    }
    rows.add({at(0), at(1), at(2), at(2)}, map.value[t]);
  }
}

}  // namespace

void DataRange::add(double value) {
  if (!std::isfinite(value)) return;
  low = std::min(low, value);
  high = std::max(high, value);
}

DataRange range_of_values(const Panel& panel) {
  DataRange range;
  for (const TriangleMap& map : panel.maps)
    for (const double value : map.value) range.add(value);
  for (const PlotCurve& curve : panel.curves)
    for (const double value : curve.value) range.add(value);
  return range;
}

DataRange coloured_range(const Panel& panel) {
  DataRange range = range_of_values(panel);
  if (!range.known()) range = {0, 1};
  range.low = panel.scale.low.value_or(range.low), range.high = panel.scale.high.value_or(range.high);
  if (!(range.high > range.low)) range.high = range.low + 1;
  return range;
}

std::string map_rows(const Panel& panel, const TriangleMap& map) {
  PieceRows rows;
  const DataRange range = coloured_range(panel);
  for (const std::array<int, 2>& sign : signs(map)) {
    if (map.at_corners.empty()) {
      add_triangles(rows, map, sign);
      continue;
    }
    for (std::size_t t = 0; t < map.corners.size(); ++t) {
      std::vector<Corner> triangle;
      for (std::size_t k = 0; k < 3; ++k) triangle.push_back({corner(map, t, k, sign), map.at_corners[t][k]});
      add_bands(rows, triangle, range);
    }
  }
  return rows.text();
}

}  // namespace validate
