#include "compare/documents/plots/gnuplot_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <sstream>
#include <vector>

#include "compare/documents/plots/gnuplot.hpp"

namespace validate {
namespace {

// In SVG units.
constexpr double title_height = 34, caption_line = 16, caption_padding = 12;
constexpr double caption_letter = 6.9;  // the mean width of one, font size 10

struct Box {
  double left, right, bottom, top;
};

std::string margins(const Plot& plot, const Box& box) {
  return fmt::format(
      "set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\nset bmargin at screen {:.4f}\n"
      "set tmargin at screen {:.4f}\n",
      box.left / plot.width, box.right / plot.width, box.bottom / plot.height, box.top / plot.height);
}

/// Characters, not bytes.
std::size_t length(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

std::vector<std::string> caption_lines(const Plot& plot) {
  const auto longest = static_cast<std::size_t>((plot.width - 30) / caption_letter);
  std::vector<std::string> lines;
  std::istringstream words(plot.caption);
  for (std::string word; words >> word;) {
    const bool belongs_to_the_last = word.starts_with("%") && !lines.empty();
    if (lines.empty() || (!belongs_to_the_last && length(lines.back()) + 1 + length(word) > longest))
      lines.push_back(word);
    else
      lines.back() += " " + word;
  }
  return lines;
}

double caption_height(const Plot& plot) {
  const std::size_t lines = caption_lines(plot).size();
  return lines == 0 ? 0 : caption_padding + caption_line * static_cast<double>(lines);
}

struct Cell {
  std::size_t row, column, rows;
};

Cell cell_of(const Plot& plot, std::size_t panel) {
  const auto columns = static_cast<std::size_t>(plot.columns);
  return {panel / columns, panel % columns, (plot.panels.size() + columns - 1) / columns};
}

}  // namespace

std::string map_place(const Plot& plot, std::size_t panel) {
  constexpr double left = 84, right = 126, bottom = 76, top = 48;
  const double title = plot.title.empty() ? 0 : title_height, caption = caption_height(plot);
  const auto [row, column, rows] = cell_of(plot, panel);
  const double width = plot.width / static_cast<double>(plot.columns);
  const double height = (plot.height - title - caption) / static_cast<double>(rows);
  const double x = width * static_cast<double>(column);
  const double y = plot.height - title - height * static_cast<double>(row);
  return margins(plot, {x + left, x + width - right, y - height + bottom, y - top});
}

std::string row_place(const Plot& plot, std::size_t panel) {
  if (plot.row_shares.empty()) return {};
  constexpr double left = 84, gap = 30, bottom = 66;
  const double top = (plot.title.empty() ? 0 : title_height) + (plot.panels.front().title.empty() ? 16 : 44);
  const Cell cell = cell_of(plot, panel);
  const double whole = plot.height - top - bottom - caption_height(plot) - gap * static_cast<double>(cell.rows - 1);
  const auto shares = plot.row_shares.begin();
  const double sum = std::accumulate(shares, plot.row_shares.end(), 0.0);
  const double above = std::accumulate(shares, shares + static_cast<std::ptrdiff_t>(cell.row), 0.0);
  const double y = plot.height - top - whole * above / sum - gap * static_cast<double>(cell.row);
  const double width = plot.width / static_cast<double>(plot.columns), x = width * static_cast<double>(cell.column);
  return margins(plot, {x + left, x + width - plot.right_margin, y - whole * plot.row_shares[cell.row] / sum, y});
}

bool shares_axis_below(const Plot& plot, std::size_t panel) {
  return !plot.row_shares.empty() && panel + static_cast<std::size_t>(plot.columns) < plot.panels.size();
}

std::string letter(const Plot& plot, std::size_t panel, bool oblique) {
  if (plot.panels.size() < 2) return {};
  if (oblique) {
    const Cell cell = cell_of(plot, panel);
    return fmt::format("set label '{}' at screen {:.4f},{:.4f} font 'DejaVu Sans Bold,13'\n",
                       static_cast<char>('a' + panel),
                       (static_cast<double>(cell.column) + 0.11) / static_cast<double>(plot.columns),
                       1 - (static_cast<double>(cell.row) + 0.11) / static_cast<double>(cell.rows));
  }
  return fmt::format("set label '{}' at graph 0,1 offset character -2.6,0.7 font 'DejaVu Sans Bold,13'\n",
                     static_cast<char>('a' + panel));
}

std::string colour_box(const Plot& plot, std::size_t panel) {
  const Cell cell = cell_of(plot, panel);
  const auto columns = static_cast<double>(plot.columns), rows = static_cast<double>(cell.rows);
  return fmt::format("set colorbox vertical user origin screen {:.4f},{:.4f} size screen {:.4f},{:.4f}\n",
                     (static_cast<double>(cell.column) + 0.82) / columns,
                     1 - (static_cast<double>(cell.row) + 0.65) / rows, 0.03 / columns, 0.4 / rows);
}

std::string caption_commands(const Plot& plot) {
  std::string text;
  double y = caption_height(plot) - caption_line * 0.7;
  for (const std::string& line : caption_lines(plot)) {
    text += fmt::format("set label {} at screen {:.4f},{:.4f} left font ',10'\n", gnuplot_quoted(line),
                        15.0 / plot.width, y / plot.height);
    y -= caption_line;
  }
  return text;
}

double caption_share(const Plot& plot) { return caption_height(plot) / plot.height; }

}  // namespace validate
