#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "compare/base/file.hpp"
#include "compare/documents/bytes/h5.hpp"
#include "compare/documents/plots/draw.hpp"
#include "compare/documents/plots/plot_csv.hpp"
#include "compare/figures/paper_figure.hpp"
#include "compare/results/result.hpp"

namespace validate {
namespace {

std::string csv(const PaperFigure& figure) {
  std::string text = fmt::format("# title: figure {}: {}\n", figure.number, figure.title);
  for (const FigureNumber& n : figure.numbers)
    fmt::format_to(std::back_inserter(text), "# number: {}: ours {:.6g} {}, reference {:.6g} {} ({}){}\n", n.what,
                   n.ours, n.unit, n.reference, n.unit, n.source, n.comment.empty() ? "" : "; " + n.comment);
  for (const std::string& remark : figure.remarks) text += "# remark: " + remark + "\n";
  text += "# last column: upper edge of a band, or the value of a map's triangle whose centroid is x, y\n";
  return text + plot_rows(plot_of(figure), Corners::left_out);
}

void write_field(h5::Group& panel, const TriangleMap& field) {
  h5::Group group = panel.group("field");
  group.attribute("name", field.name);
  group.data_set(field.key, field.value).attribute("meaning", "one value per triangle");
  for (int corner = 0; corner < 3; ++corner)
    for (int axis = 0; axis < 2; ++axis) {
      std::vector<double> values;
      for (const auto& corners : field.corners) values.push_back(corners[static_cast<std::size_t>(corner)][axis]);
      group.data_set(fmt::format("corner{}_{}_A", corner, axis == 0 ? "x" : "y"), values)
          .attribute("meaning", "in the reference");
    }
}

void write_h5(const PaperFigure& figure, const std::filesystem::path& target) {
  h5::File file;
  {
    h5::Group& root = file.root();
    root.attribute("schema", document_schema);
    root.attribute("title", figure.title);
    h5::Group panels = root.group("panels");
    for (std::size_t p = 0; p < figure.panels.size(); ++p) {
      const Panel& panel = figure.panels[p];
      h5::Group one = panels.group(fmt::format("{}", p));
      one.attribute("title", panel.title);
      for (std::size_t c = 0; c < panel.curves.size(); ++c) {
        h5::Group curve = one.group(fmt::format("{}", c));
        curve.attribute("name", panel.curves[c].name);
        curve.data_set(panel.x.key, panel.curves[c].x).attribute("meaning", axis_text(panel.x));
        curve.data_set(panel.y.key, panel.curves[c].y).attribute("meaning", axis_text(panel.y));
        if (!panel.curves[c].y_high.empty()) curve.data_set(panel.y.key + "_high", panel.curves[c].y_high);
      }
    }
    for (std::size_t p = 0; p < figure.panels.size(); ++p)
      if (!figure.panels[p].maps.empty()) {
        h5::Group one = panels.group(fmt::format("{}-map", p));
        write_field(one, figure.panels[p].maps.front());
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
  write_file(target, file.image());
}

}  // namespace

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

Plot plot_of(const PaperFigure& figure) {
  const int rows = static_cast<int>(figure.panels.size() + 1) / 2;
  const bool related = !figure.row_shares.empty();  // the lower panels are smaller
  return {.title = fmt::format("Figure {}: {}", figure.number, figure.title),
          .panels = figure.panels,
          .columns = 2,
          .width = 1200,
          .height = (related ? 460 : 560) * rows,
          .row_shares = figure.row_shares};
}

void write_paper_figure(const PaperFigure& figure, const std::filesystem::path& folder) {
  const std::string name = fmt::format("figure{}", figure.number);
  write_file(folder / (name + ".csv"), csv(figure));
  write_h5(figure, folder / (name + ".h5"));
  if (const auto warning = draw(plot_of(figure), folder, name)) spdlog::warn("{}", *warning);
}

}  // namespace validate
