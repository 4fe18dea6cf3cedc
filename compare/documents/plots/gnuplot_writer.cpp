#include "compare/documents/plots/gnuplot_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "compare/documents/plots/gnuplot.hpp"
#include "compare/documents/plots/gnuplot_data.hpp"
#include "compare/documents/plots/gnuplot_layout.hpp"
#include "compare/documents/plots/gnuplot_maps.hpp"

namespace validate {
namespace {

const char* dash_text(Dash dash) {
  switch (dash) {
    case Dash::dashed:
      return "'-'";
    case Dash::dotted:
      return "'.'";
    case Dash::long_dashed:
      return "'_'";
    case Dash::dash_dotted:
      return "'-.'";
    case Dash::long_dash_dotted:
      return "'_.'";
    case Dash::solid:
      break;
  }
  return "1";
}

int point_type(const Points& points) {
  switch (points.marker) {
    case Marker::square:
      return points.open ? 4 : 5;
    case Marker::triangle:
      return points.open ? 8 : 9;
    case Marker::diamond:
      return points.open ? 12 : 13;
    case Marker::circle:
      break;
  }
  return points.open ? 6 : 7;
}

std::string style(const PlotCurve& curve) {
  const std::string colour = curve.value.empty() ? fmt::format("rgb '{}'", hex(curve.colour)) : "palette";
  if (!curve.y_high.empty()) return fmt::format("filledcurves fc {} fs solid 0.5 noborder", colour);
  std::string text = curve.line && curve.points ? "linespoints" : curve.line ? "lines" : "points";
  text += " lc " + colour;
  if (curve.line) text += fmt::format(" lw {:g} dt {}", curve.line->width, dash_text(curve.line->dash));
  const Points points = curve.points.value_or(Points{});
  if (curve.points || !curve.line) text += fmt::format(" pt {} ps {:.2g}", point_type(points), points.size);
  return text;
}

std::string title_clause(const std::string& name, bool in_legend) {
  return in_legend && !name.empty() ? "title " + gnuplot_quoted(name) : "notitle";
}

const char* legend_place(Legend legend) {
  switch (legend) {
    case Legend::left_top:
      return "inside left top";
    case Legend::right_top:
      return "inside right top";
    case Legend::right_bottom:
      return "inside right bottom";
    case Legend::centre_top:
      return "inside center top";
    case Legend::centre:
      return "inside center center";
    case Legend::above:
      return "outside above center maxrows 2";
    case Legend::outside_right:
      return "outside right center";
    case Legend::none:
      break;
  }
  return nullptr;
}

std::string bound(const std::optional<double>& value) { return value ? fmt::format("{:.6g}", *value) : "*"; }

/// Multiples of powers of ten, the fewer the longer the axis.
std::string logarithmic_tics(double low, double high) {
  const std::vector<double> multiples = high / low > 1000 ? std::vector<double>{1}
                                        : high / low > 10 ? std::vector<double>{1, 2, 5}
                                        : high / low > 4  ? std::vector<double>{1, 2, 3, 4, 6, 8}
                                                          : std::vector<double>{1, 1.2, 1.5, 2, 3, 4, 5, 6, 7, 8, 9};
  std::string text;
  for (int power = static_cast<int>(std::floor(std::log10(low))); std::pow(10, power) <= high; ++power)
    for (const double times : multiples) {
      const double at = times * std::pow(10, power);
      fmt::format_to(std::back_inserter(text), "{}'{:g}' {:g}", text.empty() ? "" : ", ", at, at);
    }
  return text;
}

/// Some five of them on an axis of this length: 1, 2 or 5 times a power of ten.
double step_of_tics(double length) {
  const double power = std::pow(10, std::floor(std::log10(length / 5)));
  const std::array steps = {power, 2 * power, 5 * power, 10 * power};
  return *std::ranges::min_element(steps, {}, [&](double step) { return std::abs(length / step - 5.5); });
}

/// x of the points, or y.
DataRange range_of(const Panel& panel, char which) {
  DataRange range;
  for (const PlotCurve& curve : panel.curves) {
    for (const double value : which == 'x' ? curve.x : curve.y) range.add(value);
    if (which == 'y')
      for (const double value : curve.y_high) range.add(value);
  }
  return range;
}

std::string axis_commands(const Panel& panel, const Axis& axis, char which, bool few_tics) {
  std::string text = fmt::format("set {}label {}\n", which, gnuplot_quoted(axis_text(axis)));
  std::optional<double> low = axis.low, high = axis.high;
  const DataRange range = range_of(panel, which);
  if (axis.logarithmic && range.known() && range.low > 0) {
    low = low.value_or(range.low / 1.15), high = high.value_or(range.high * 1.15);
    text += fmt::format("set logscale {0}\nset {0}tics ({1})\n", which, logarithmic_tics(*low, *high));
  }
  if (few_tics && !axis.logarithmic && low && high && *high > *low)
    text += fmt::format("set {}tics {:g}\n", which, step_of_tics(*high - *low));
  if (!axis.categories.empty()) {
    low = -0.6, high = static_cast<double>(axis.categories.size()) - 0.4;
    text += fmt::format("set {}tics rotate by 45 right (", which);
    for (std::size_t i = 0; i < axis.categories.size(); ++i)
      text += fmt::format("{}{} {}", i ? ", " : "", gnuplot_quoted(axis.categories[i]), i);
    text += ")\n";
  }
  // A curve may end at a free axis's end: not on the frame itself.
  if (which == 'y' && !low && !high) text += "set offsets 0, 0, graph 0.05, graph 0.05\n";
  return text + fmt::format("set {}range [{}:{}]\n", which, bound(low), bound(high));
}

/// A place of an axis with the whole of the other one: from the panel's beginning (0) or to its end (1).
std::string place(Along along, double at, int end) {
  const std::string here = std::isfinite(at) ? fmt::format("first {:.6g}", at) : "graph 1";
  return along == Along::x ? fmt::format("{},graph {}", here, end) : fmt::format("graph {},{}", end, here);
}

std::string across(Along along, double at, Colour colour, Dash dash) {
  return fmt::format("set arrow from {} to {} nohead lc rgb '{}' lw 1 dt {} back\n", place(along, at, 0),
                     place(along, at, 1), hex(colour), dash_text(dash));
}

std::string zones_and_marks(const Panel& panel) {
  std::string text;
  for (const Zone& zone : panel.zones) {
    fmt::format_to(std::back_inserter(text),
                   "set object rectangle from {} to {} fc rgb '{}' fs solid 0.12 noborder behind\n",
                   place(zone.along, zone.from, 0), place(zone.along, zone.to, 1), hex(zone.colour));
    if (zone.edge) text += across(zone.along, zone.from, zone.colour, Dash::dashed);
  }
  for (const Mark& mark : panel.marks) text += across(mark.along, mark.at, mark.colour, mark.dash);
  return text;
}

/// Whether the panel's sheet is seen obliquely.
bool is_oblique(const Panel& panel) {
  return std::ranges::any_of(panel.maps, [](const TriangleMap& map) { return !map.height.empty(); });
}

std::string colour_commands(const Panel& panel) {
  std::string colours, tics;
  if (!panel.scale.classes.empty()) {
    for (std::size_t i = 0; i < panel.scale.classes.size(); ++i) {
      const auto& [name, colour] = panel.scale.classes[i];
      fmt::format_to(std::back_inserter(colours), "{}{} '{}'", i ? ", " : "", i, hex(colour));
      fmt::format_to(std::back_inserter(tics), "{}{} {}", i ? ", " : "", gnuplot_quoted(name), i);
    }
    return fmt::format("set palette defined ({}) maxcolors {}\nset cbrange [-0.5:{}.5]\nset cbtics ({})\n", colours,
                       panel.scale.classes.size(), panel.scale.classes.size() - 1, tics);
  }
  for (std::size_t i = 0; i < scale_of_fields().size(); ++i)
    fmt::format_to(std::back_inserter(colours), "{}{} '{}'", i ? ", " : "", i, scale_of_fields()[i]);
  const DataRange range = coloured_range(panel), values = range_of_values(panel);
  std::string over;  // the colours' last one stands for all that is beyond
  if (panel.scale.high && values.known() && values.high > 1.01 * range.high)
    over = fmt::format("set cbtics add ('≥ {:.3g}' {:.6g})\n", range.high, range.high);
  const std::string label = gnuplot_quoted(panel.scale.label);
  return fmt::format(
      "set palette defined ({}) maxcolors 0\nset cbrange [{:.6g}:{:.6g}]\n{}{}\n", colours, range.low, range.high, over,
      is_oblique(panel) ? "set cblabel " + label : fmt::format("set label {} at graph 1.05,1.06", label));
}

std::string splot(const Plot& plot, std::size_t p) {
  const Panel& panel = plot.panels[p];
  std::vector<std::string> clauses;
  for (std::size_t m = 0; m < panel.maps.size(); ++m)
    clauses.push_back(fmt::format("{} using 1:2:3:4 with pm3d notitle", map_block(p, m)));
  for (std::size_t c = 0; c < panel.curves.size(); ++c)
    if (!panel.curves[c].x.empty())
      clauses.push_back(fmt::format("{} using 1:2:(0){} with {} notitle", curve_block(p, c),
                                    panel.curves[c].value.empty() ? "" : ":3", style(panel.curves[c])));
  const std::string drawn = colour_commands(panel) + fmt::format("splot {}\n", fmt::join(clauses, ", \\\n     "));
  if (is_oblique(panel))
    return map_place(plot, p) +
           "set pm3d depthorder corners2color c1 @map_border\nset view 60,30,1.0\nset view equal xyz\n"
           "set xyplane 0\nunset key\nunset border\nunset xtics\nunset ytics\nunset ztics\nunset xlabel\n"
           "unset ylabel\n" +
           colour_box(plot, p) + drawn;
  return map_place(plot, p) +
         "set pm3d map corners2color c1 scansbackward @map_border\nunset key\nset border 31 lw 0.5\n"
         "set xlabel offset 0,0.4\nset ylabel offset -0.5,0\n" +
         drawn;
}

std::string legend_commands(Legend legend) {
  const char* const where = legend_place(legend);
  if (!where) return "unset key\n";
  return fmt::format("set key {} Left reverse samplen 2.5 spacing 1.15 font ',10'\n", where);
}

std::string plot_in_two_dimensions(const Panel& panel, std::size_t p) {
  std::vector<std::string> clauses;
  for (std::size_t b = 0; b < panel.bars.size(); ++b)
    clauses.push_back(fmt::format("{} using 1:2:3:4:5:6 with boxxyerror fs solid 0.85 noborder fc rgb '{}' {}",
                                  bar_block(p, b), hex(panel.bars[b].colour), title_clause(panel.bars[b].name, true)));
  for (std::size_t c = 0; c < panel.curves.size(); ++c) {
    const PlotCurve& curve = panel.curves[c];
    if (curve.x.empty()) continue;
    clauses.push_back(fmt::format("{} using {} with {} {}", curve_block(p, c), curve.y_high.empty() ? "1:2" : "1:2:3",
                                  style(curve), title_clause(curve.name, curve.in_legend)));
  }
  for (const Zone& zone : panel.zones)
    if (!zone.name.empty())
      clauses.push_back(
          fmt::format("NaN with boxes fs solid 0.25 lc rgb '{}' {}", hex(zone.colour), title_clause(zone.name, true)));
  if (clauses.empty()) clauses.emplace_back("NaN notitle");
  return fmt::format("{}set border 3 lw 1\nset grid lc rgb '#e4e4e4' lw 1 lt 1\nplot {}\n",
                     legend_commands(panel.legend), fmt::join(clauses, ", \\\n     "));
}

/// Words in the colour of what they name, with a pale edge so that lines behind do not cross them out.
std::string words_in_panel(const Panel& panel) {
  std::string text;
  for (const TextLabel& label : panel.labels)
    fmt::format_to(std::back_inserter(text),
                   "set label {} at first {:.6g},{:.6g} left offset character 0.6,0 tc rgb '{}' font ',10' front\n",
                   gnuplot_quoted(label.text), label.x, label.y, hex(label.colour));
  return text;
}

std::string panel_commands(const Plot& plot, std::size_t index) {
  const Panel& panel = plot.panels[index];
  std::string text = "reset\nset minussign\nset format '%h'\nset tics nomirror out\n";
  if (!panel.title.empty())
    text += "set title " + gnuplot_quoted(panel.title) +
            (plot.panels.size() == 1 && !is_map(panel) ? " font ',14'\n" : "\n");
  const bool few_tics = panel.equal_axes || !plot.row_shares.empty();
  text += axis_commands(panel, panel.x, 'x', few_tics) + axis_commands(panel, panel.y, 'y', few_tics);
  if (shares_axis_below(plot, index)) text += "unset xlabel\nset format x ''\n";
  if (panel.equal_axes) text += "set size ratio -1\n";
  text +=
      zones_and_marks(panel) + words_in_panel(panel) + letter(plot, index, is_oblique(panel)) + row_place(plot, index);
  if (index + 1 == plot.panels.size()) text += caption_commands(plot);
  return text + (is_map(panel) ? splot(plot, index) : plot_in_two_dimensions(panel, index));
}

std::string commands(const Plot& plot) {
  const auto count = static_cast<int>(plot.panels.size());
  std::string text;
  if (count > 1) {
    text = fmt::format("set multiplot layout {},{}", (count + plot.columns - 1) / plot.columns, plot.columns);
    if (!plot.title.empty()) text += " title " + gnuplot_quoted(plot.title) + " font ',14'";
    text += "\n";
  }
  for (std::size_t p = 0; p < plot.panels.size(); ++p) text += panel_commands(plot, p);
  return text + (count > 1 ? "unset multiplot\n" : "");
}

std::string terminal(const Plot& plot, PictureFormat format) {
  switch (format) {
    case PictureFormat::png:
      return fmt::format("pngcairo size {},{} font 'DejaVu Sans,12' noenhanced fontscale 2 linewidth 2 pointscale 2",
                         2 * plot.width, 2 * plot.height);
    case PictureFormat::pdf:  // 0.2 mm a unit: what is 12 units high in the others is 6.8 points
      return fmt::format(
          "pdfcairo size {:.3f}cm,{:.3f}cm font 'DejaVu Sans,12' noenhanced fontscale 0.567 linewidth 0.8 "
          "pointscale 0.567",
          0.02 * plot.width, 0.02 * plot.height);
    case PictureFormat::svg:
      break;
  }
  return fmt::format("svg size {},{} font 'DejaVu Sans,12' noenhanced background rgb 'white'", plot.width, plot.height);
}

}  // namespace

const char* extension(PictureFormat format) {
  return format == PictureFormat::png ? ".png" : format == PictureFormat::pdf ? ".pdf" : ".svg";
}

std::string gnuplot_script(const Plot& plot, const std::vector<Picture>& pictures) {
  std::string text = "set encoding utf8\n" + gnuplot_data(plot);
  for (const Picture& picture : pictures) {
    // Pixels between neighbouring triangles stay pale unless each is drawn a little larger; in an SVG that is a stroke
    // each.
    text += fmt::format("set terminal {}\nmap_border = '{}'\nset output {}\n{}unset output\n",
                        terminal(plot, picture.format),
                        picture.format == PictureFormat::png ? "border retrace" : "noborder",
                        gnuplot_quoted(picture.file.string()), commands(plot));
  }
  return text;
}

}  // namespace validate
