// A drawing as plain data: panels with axes, curves, bars and maps. How it looks in detail is the writer's.
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "compare/documents/plots/colours.hpp"

namespace validate {

enum class Dash { solid, dashed, dotted, long_dashed, dash_dotted, long_dash_dotted };
enum class Marker { circle, square, triangle, diamond };

/// The marker of the n-th of several curves: with its colour, so that they differ in grey too.
constexpr Marker nth_marker(std::size_t n) {
  constexpr std::array all = {Marker::circle, Marker::square, Marker::triangle, Marker::diamond};
  return all[n % all.size()];
}

struct Line {
  Dash dash = Dash::solid;
  double width = 1.5;
};

struct Points {
  Marker marker = Marker::circle;
  double size = 0.7;
  bool open = false;
};

/// Points in order, drawn by a line, by markers or by both; with y_high the band from y to y_high.
struct PlotCurve {
  std::string name;  ///< in the legend and in the data
  std::vector<double> x, y;
  std::vector<double> y_high = {};
  std::vector<double> value = {};  ///< one a point, coloured by the panel's scale (markers only)
  Colour colour = Colour::black;
  std::optional<Line> line = {};
  std::optional<Points> points = {};
  bool in_legend = true;
  bool strokes = false;  ///< every two points are a line of their own
};

/// One of the shares that are stacked over the categories of the x axis: positive ones upwards from 0, negative ones
/// downwards.
struct StackedBars {
  std::string name;
  Colour colour = Colour::grey;
  std::vector<double> y;  ///< one a category
};

/// A value per triangle.
struct TriangleMap {
  std::string name, key;  ///< key: name with unit for the data files
  std::vector<std::array<Eigen::Vector2d, 3>> corners;
  std::vector<double> value;
  bool quarter = false;                                ///< drawn with its mirror images in x = 0 and y = 0
  std::vector<std::array<double, 3>> at_corners = {};  ///< values there: drawn in bands of equal value, not by triangle
  std::vector<std::array<double, 3>> height = {};      ///< of the corners: seen obliquely, not from above
};

struct Axis {
  std::string label, unit;  ///< unit empty for a bare number
  std::string key;          ///< name with unit for the data files: depth_nm
  std::optional<double> low = {}, high = {};
  bool logarithmic = false;
  std::vector<std::string> categories = {};  ///< names at 0, 1, 2, …
};

/// Label and unit as the axis says them.
std::string axis_text(const Axis& axis);

/// Which axis a place belongs to.
enum class Along { x, y };

/// A shaded stretch of an axis, across the whole panel.
struct Zone {
  Along along = Along::x;
  double from = 0, to = std::numeric_limits<double>::infinity();  ///< infinity: to the panel's end
  Colour colour = Colour::grey;
  std::string name = {};  ///< in the legend, where there is one
  bool edge = false;      ///< a thin line at `from`
};

/// A thin line across the whole panel at a place of an axis.
struct Mark {
  Along along = Along::x;
  double at = 0;
  Dash dash = Dash::solid;
  Colour colour = Colour::black;
};

/// A word at a place of the panel, in the colour of what it names.
struct TextLabel {
  std::string text;
  double x = 0, y = 0;  ///< in the axes' units
  Colour colour = Colour::black;
};

/// How values of maps and of coloured points become colours.
struct ColourScale {
  std::string label = {};  ///< beside the bar
  std::optional<double> low = {}, high = {};
  struct Class {
    std::string name;
    Colour colour;
  };
  std::vector<Class> classes = {};  ///< in place of a range: of the values 0, 1, 2, …
};

enum class Legend { none, left_top, right_top, right_bottom, centre_top, centre, above, outside_right };

struct Panel {
  std::string title;
  Axis x, y;
  Legend legend = Legend::none;
  bool equal_axes = false;  ///< a length is as long in x as in y
  std::vector<PlotCurve> curves = {};
  std::vector<StackedBars> bars = {};
  std::vector<Zone> zones = {};
  std::vector<Mark> marks = {};
  std::vector<TextLabel> labels = {};  ///< to the right of their places
  std::vector<TriangleMap> maps = {};  ///< the curves are drawn over them
  ColourScale scale = {};
};

/// Whether the panel is seen from above, with a colour bar.
bool is_map(const Panel& panel);

/// Widths of a journal's page, in SVG units of 0.2 mm: both columns, or one.
inline constexpr int double_column = 900, single_column = 425;

/// Panels row by row, with letters where there are several. Sizes are SVG units; the PNG has twice as many pixels, the
/// PDF is 0.2 mm a unit.
struct Plot {
  std::string title = {};
  std::vector<Panel> panels = {};  ///< none: there is nothing to draw
  int columns = 1;
  int width = double_column, height = 640;
  std::vector<double> row_shares = {};  ///< of the height, one a row: panels one above another share their x axis
  double right_margin = 20;             ///< beside such panels, for their labels
  std::string caption = {};             ///< below, broken into lines
};

}  // namespace validate
