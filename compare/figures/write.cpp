#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "compare/base/file.hpp"
#include "compare/documents/bytes/h5.hpp"
#include "compare/documents/plots/figure.hpp"
#include "compare/documents/plots/gnuplot.hpp"
#include "compare/documents/texts/summary_json.hpp"
#include "compare/figures/paper_figure.hpp"

namespace validate {
namespace {

std::string block_name(std::size_t panel, std::size_t curve) { return fmt::format("$p{}c{}", panel, curve); }

std::string data_block(const FigureCurve& curve, const std::string& name) {
  std::string text = name + " << EOD\n";
  for (std::size_t i = 0; i < curve.x.size(); ++i)
    fmt::format_to(std::back_inserter(text), "{} {}{}\n{}", curve.x[i], curve.y[i],
                   curve.y_high.empty() ? "" : fmt::format(" {}", curve.y_high[i]),
                   curve.broken && i % 2 == 1 ? "\n\n" : "");
  return text + "EOD\n";
}

/// Each triangle as a surface of its own: a quadrilateral two corners of which coincide.
std::string data_block(const FigureField& field, const std::string& name) {
  std::string text = name + " << EOD\n";
  for (std::size_t i = 0; i < field.value.size(); ++i) {
    const auto& c = field.corners_A[i];
    const auto point = [&](const Eigen::Vector2d& at) {
      fmt::format_to(std::back_inserter(text), "{:.3f} {:.3f} {:.6g}\n", at[0], at[1], field.value[i]);
    };
    point(c[0]), point(c[1]);
    text += "\n";
    point(c[2]), point(c[2]);
    text += "\n\n";
  }
  return text + "EOD\n";
}

std::string field_name(std::size_t panel) { return fmt::format("$p{}field", panel); }

/// A map, and over it the panel's curves.
std::string map_commands(const FigurePanel& panel, std::size_t index) {
  std::string text = fmt::format(
      "unset grid\nset view map\nset pm3d map corners2color c1\nset size ratio -1\nunset key\n"
      "splot {} using 1:2:3 with pm3d notitle",
      field_name(index));
  for (std::size_t c = 0; c < panel.curves.size(); ++c)
    fmt::format_to(std::back_inserter(text), ", \\\n     {} using 1:2:(0) with {} notitle", block_name(index, c),
                   panel.curves[c].style);
  return text + "\n";
}

std::string panel_commands(const FigurePanel& panel, std::size_t index) {
  std::string text = fmt::format(
      "unset object\nunset arrow\nset autoscale\nset cbtics autofreq\nset palette defined (0 '#440154', 1 "
      "'#3b528b', 2 '#21918c', "
      "3 '#5ec962', 4 "
      "'#fde725') maxcolors 0\nset title {}\nset xlabel {}\nset ylabel {}\nset border 3 lw "
      "1\n"
      "set tics nomirror out\nset grid lc rgb '#e4e4e4' lw 1 lt 1\n{}",
      gnuplot_quoted(panel.title), gnuplot_quoted(panel.x_label), gnuplot_quoted(panel.y_label), panel.settings);
  if (!panel.fields.empty()) return text + map_commands(panel, index);
  bool first = true;
  for (std::size_t c = 0; c < panel.curves.size(); ++c) {
    if (panel.curves[c].x.empty()) continue;
    fmt::format_to(std::back_inserter(text), "{}{} using {} with {} title {}", first ? "plot " : ", \\\n     ",
                   block_name(index, c), panel.curves[c].y_high.empty() ? "1:2" : "1:2:3", panel.curves[c].style,
                   gnuplot_quoted(panel.curves[c].name));
    first = false;
  }
  return text + (first ? "plot NaN notitle\n" : "\n");
}

/// Two panels to a row.
std::string commands(const PaperFigure& figure) {
  std::string text;
  for (std::size_t p = 0; p < figure.panels.size(); ++p)
    for (std::size_t c = 0; c < figure.panels[p].curves.size(); ++c)
      text += data_block(figure.panels[p].curves[c], block_name(p, c));
  for (std::size_t p = 0; p < figure.panels.size(); ++p)
    if (!figure.panels[p].fields.empty()) text += data_block(figure.panels[p].fields.front(), field_name(p));
  text += fmt::format("set multiplot layout {},2 title {}\n", (figure.panels.size() + 1) / 2,
                      gnuplot_quoted(fmt::format("Figure {}: {}", figure.number, figure.title)));
  for (std::size_t p = 0; p < figure.panels.size(); ++p) text += panel_commands(figure.panels[p], p);
  return text + "unset multiplot\n";
}

std::string csv(const PaperFigure& figure) {
  std::string text = fmt::format("# title: figure {}: {}\n", figure.number, figure.title);
  for (const FigureNumber& n : figure.numbers)
    fmt::format_to(std::back_inserter(text), "# number: {}: ours {:.6g} {}, reference {:.6g} {} ({}){}\n", n.what,
                   n.ours, n.unit, n.reference, n.unit, n.source, n.comment.empty() ? "" : "; " + n.comment);
  for (const std::string& remark : figure.remarks) text += "# remark: " + remark + "\n";
  text += "# last column: upper edge of a band, or the value of a map's triangle whose centroid is x, y\n";
  text += "panel,curve,x_key,y_key,x,y,upper_or_value\n";
  const auto row = [&](const FigurePanel& panel, const std::string& name, double x, double y, const std::string& last) {
    fmt::format_to(std::back_inserter(text), "\"{}\",\"{}\",{},{},{},{},{}\n", panel.title, name, panel.x_key,
                   panel.y_key, x, y, last);
  };
  for (const FigurePanel& panel : figure.panels) {
    for (const FigureCurve& curve : panel.curves)
      for (std::size_t i = 0; i < curve.x.size(); ++i)
        row(panel, curve.name, curve.x[i], curve.y[i], curve.y_high.empty() ? "" : fmt::format("{}", curve.y_high[i]));
    for (const FigureField& field : panel.fields)
      for (std::size_t i = 0; i < field.value.size(); ++i) {
        const Eigen::Vector2d middle = (field.corners_A[i][0] + field.corners_A[i][1] + field.corners_A[i][2]) / 3;
        row(panel, field.key, middle[0], middle[1], fmt::format("{}", field.value[i]));
      }
  }
  return text;
}

void write_field(h5::Group& panel, const FigureField& field) {
  h5::Group group = panel.group("field");
  group.attribute("name", field.name);
  group.data_set(field.key, field.value).attribute("meaning", "one value per triangle");
  for (int corner = 0; corner < 3; ++corner)
    for (int axis = 0; axis < 2; ++axis) {
      std::vector<double> values;
      for (const auto& corners : field.corners_A) values.push_back(corners[static_cast<std::size_t>(corner)][axis]);
      group.data_set(fmt::format("corner{}_{}_A", corner, axis == 0 ? "x" : "y"), values)
          .attribute("meaning", "in the reference");
    }
}

void write_h5(const PaperFigure& figure, const std::filesystem::path& target) {
  PendingFile pending(target);
  h5::File file(pending.path());
  {
    h5::Group& root = file.root();
    root.attribute("schema", summary_schema);
    root.attribute("title", figure.title);
    h5::Group panels = root.group("panels");
    for (std::size_t p = 0; p < figure.panels.size(); ++p) {
      const FigurePanel& panel = figure.panels[p];
      h5::Group one = panels.group(fmt::format("{}", p));
      one.attribute("title", panel.title);
      for (std::size_t c = 0; c < panel.curves.size(); ++c) {
        h5::Group curve = one.group(fmt::format("{}", c));
        curve.attribute("name", panel.curves[c].name);
        curve.data_set(panel.x_key, panel.curves[c].x).attribute("meaning", panel.x_label);
        curve.data_set(panel.y_key, panel.curves[c].y).attribute("meaning", panel.y_label);
        if (!panel.curves[c].y_high.empty()) curve.data_set(panel.y_key + "_high", panel.curves[c].y_high);
      }
    }
    for (std::size_t p = 0; p < figure.panels.size(); ++p)
      if (!figure.panels[p].fields.empty()) {
        h5::Group one = panels.group(fmt::format("{}-map", p));
        write_field(one, figure.panels[p].fields.front());
      }
    root.attribute("remarks", figure.remarks);
    h5::Group numbers = root.group("numbers");
    for (std::size_t i = 0; i < figure.numbers.size(); ++i) {
      const FigureNumber& n = figure.numbers[i];
      h5::Group one = numbers.group(fmt::format("{}", i));
      one.attribute("what", n.what);
      one.attribute("unit", n.unit);
      one.attribute("source", n.source);
      one.attribute("reference", n.reference);
      one.attribute("ours", n.ours);
      one.attribute("comment", n.comment);
    }
  }
  file.close();
  pending.commit();
}

}  // namespace

bool passes(const FigureNumber& n) {
  return n.tolerance <= 0 || std::abs(n.ours - n.reference) <= n.tolerance * std::abs(n.reference);
}

std::string numbers_text(const PaperFigure& figure) {
  std::string text = fmt::format("Figure {}: {}\n{:<66}{:>10}{:>11}  {:<6}{:>8}\n", figure.number, figure.title, "",
                                 "ours", "reference", "", "");
  std::vector<std::string> remarks;  // each once, as it belongs to several lines
  for (const FigureNumber& n : figure.numbers) {
    fmt::format_to(std::back_inserter(text), "{:<66}{:>10.5g}{:>11.5g}  {:<6}{:>+8.2f} %{}\n", n.what, n.ours,
                   n.reference, n.unit, 100 * (n.ours / n.reference - 1), passes(n) ? "" : "  DIFFERS");
    for (const std::string& remark : {"reference: " + n.source, n.comment})
      if (!remark.empty() && std::ranges::find(remarks, remark) == remarks.end()) remarks.push_back(remark);
  }
  for (const std::string& remark : figure.remarks) text += "  " + remark + "\n";
  for (const std::string& remark : remarks) text += "  " + remark + "\n";
  return text;
}

void write_paper_figure(const PaperFigure& figure, const std::filesystem::path& folder) {
  const std::string name = fmt::format("figure{}", figure.number);
  write_file(folder / (name + ".csv"), csv(figure));
  write_h5(figure, folder / (name + ".h5"));
  const int rows = static_cast<int>(figure.panels.size() + 1) / 2;
  if (const auto warning = draw(commands(figure), folder, name, {1200, 560 * rows})) spdlog::warn("{}", *warning);
}

}  // namespace validate
