#include "compare/documents/bytes/svg_compact.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <map>
#include <sstream>
#include <string_view>
#include <vector>

namespace validate {
namespace {

using Lines = std::vector<std::string>;

constexpr std::string_view polygon_start = "<polygon fill = '", polygon_middle = "' points = '", group_end = "</g>";

std::string_view trimmed(std::string_view line) {
  const auto first = line.find_first_not_of(" \t");
  return first == std::string_view::npos ? std::string_view() : line.substr(first);
}

bool opens(std::string_view line) { return trimmed(line).starts_with("<g "); }
bool closes(std::string_view line) { return trimmed(line) == group_end; }
bool starts_plot(std::string_view line) { return trimmed(line).starts_with("<g id=\"gnuplot_plot_"); }
bool is_polygon(std::string_view line) {
  return trimmed(line).starts_with(polygon_start) && line.find(polygon_middle) != std::string_view::npos;
}

/// The end of a group on a line of its own.
Lines lines_of(const std::string& text) {
  Lines lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    const bool closes_too = line.ends_with(group_end) && !closes(line);
    if (closes_too) line.resize(line.size() - group_end.size());
    lines.push_back(line);
    if (closes_too) lines.emplace_back(group_end);
  }
  return lines;
}

/// Without the groups that only name plots, and without empty ones.
Lines without_idle_groups(const Lines& lines) {
  Lines kept;
  std::vector<bool> idle;  // of the groups around a line
  for (const std::string& line : lines) {
    if (opens(line)) {
      idle.push_back(starts_plot(line));
      if (!idle.back()) kept.push_back(line);
    } else if (closes(line) && !idle.empty()) {
      const bool empty = !kept.empty() && opens(kept.back());
      if (!idle.back() && empty) kept.pop_back();
      if (!idle.back() && !empty) kept.push_back(line);
      idle.pop_back();
    } else {
      kept.push_back(line);
    }
  }
  return kept;
}

/// How many groups end here only for others like them to begin: 0, or 1, 2, … levels.
std::size_t levels_that_go_on(const Lines& lines, std::size_t at, const Lines& open) {
  std::size_t levels = 0;
  while (at + levels < lines.size() && closes(lines[at + levels])) ++levels;
  if (levels > open.size() || at + 2 * levels > lines.size()) return 0;
  for (std::size_t k = 0; k < levels; ++k)
    if (lines[at + levels + k] != open[open.size() - levels + k]) return 0;
  return levels;
}

/// Tenths of a pixel, so that rounding does not add up along a path.
long tenths(double x) { return std::lround(10 * x); }

std::string shown(long x) {
  return x % 10 == 0 ? fmt::format("{}", x / 10) : fmt::format("{:.1f}", 0.1 * static_cast<double>(x));
}

/// " M x,y l dx,dy … z" of a polygon, corners that coincide left out; empty for one that has no area left.
std::string path_of(std::string points) {
  for (char& c : points)
    if (c == ',') c = ' ';
  std::istringstream in(points);
  std::vector<std::pair<long, long>> corners;
  for (double x, y; in >> x >> y;)
    if (const std::pair corner(tenths(x), tenths(y)); corners.empty() || corner != corners.back())
      corners.push_back(corner);
  if (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
  if (corners.size() < 3) return {};
  std::string path = fmt::format("M{},{}l", shown(corners[0].first), shown(corners[0].second));
  for (std::size_t i = 1; i < corners.size(); ++i)
    fmt::format_to(std::back_inserter(path), "{}{},{}", i > 1 ? " " : "",
                   shown(corners[i].first - corners[i - 1].first), shown(corners[i].second - corners[i - 1].second));
  return path + "z";
}

/// Polygons waiting to be written, by colour.
class Map {
 public:
  void add(std::string_view line) {
    line = trimmed(line);
    const auto middle = line.find(polygon_middle), begin = middle + polygon_middle.size();
    paths_[std::string(line.substr(polygon_start.size(), middle - polygon_start.size()))] +=
        path_of(std::string(line.substr(begin, line.find('\'', begin) - begin)));
  }

  void flush(std::string& text) {
    for (const auto& [colour, path] : paths_)
      if (!path.empty()) text += fmt::format("<path fill='{}' d='{}'/>\n", colour, path);
    paths_.clear();
  }

 private:
  std::map<std::string, std::string> paths_;
};

}  // namespace

std::string compact_svg(const std::string& svg) {
  const Lines lines = without_idle_groups(lines_of(svg));
  std::string text;
  Map map;
  Lines open;  // the groups around a line
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (is_polygon(lines[i])) {
      map.add(lines[i]);
      continue;
    }
    if (const std::size_t levels = closes(lines[i]) ? levels_that_go_on(lines, i, open) : 0) {
      i += 2 * levels - 1;
      continue;
    }
    map.flush(text);
    if (closes(lines[i]) && !open.empty()) open.pop_back();
    if (opens(lines[i])) open.push_back(lines[i]);
    text += lines[i] + "\n";
  }
  map.flush(text);
  return text;
}

}  // namespace validate
