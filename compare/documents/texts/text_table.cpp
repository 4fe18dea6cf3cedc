#include "compare/documents/texts/text_table.hpp"

#include <algorithm>
#include <utility>

#include "compare/base/terminal.hpp"

namespace validate {
namespace {

constexpr int gap = 2;  // between columns

std::string padded(const std::string& cell, Align align, int width) {
  const std::string blanks(static_cast<std::size_t>(std::max(0, width - width_of(cell))), ' ');
  return align == Align::left ? cell + blanks : blanks + cell;
}

void end_line(std::string& text, std::string line) {
  line.resize(line.find_last_not_of(' ') + 1);
  text += line + '\n';
}

}  // namespace

TextTable::TextTable(std::vector<TextColumn> columns, int indent) : columns_(std::move(columns)), indent_(indent) {}

void TextTable::add(std::vector<std::string> cells) {
  cells.resize(columns_.size());
  rows_.push_back({std::move(cells)});
}

void TextTable::add_line(std::string line) { rows_.push_back({{}, std::move(line)}); }

std::vector<int> TextTable::widths() const {
  std::vector<int> widths;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    int widest = std::max(width_of(columns_[c].heading), width_of(columns_[c].unit));
    for (const Row& row : rows_)
      if (!row.cells.empty()) widest = std::max(widest, width_of(row.cells[c]));
    widths.push_back(widest);
  }
  return widths;
}

std::vector<bool> TextTable::shown(const std::vector<int>& widths, int width) const {
  std::vector<bool> shown(columns_.size(), true);
  const auto total = [&] {
    int sum = indent_ - gap;
    for (std::size_t c = 0; c < columns_.size(); ++c) sum += shown[c] ? gap + widths[c] : 0;
    return sum;
  };
  while (total() > width) {
    std::size_t least = columns_.size();
    for (std::size_t c = 0; c < columns_.size(); ++c)
      if (shown[c] && columns_[c].rank > 0 && (least == columns_.size() || columns_[c].rank > columns_[least].rank))
        least = c;
    if (least == columns_.size()) break;
    shown[least] = false;
  }
  return shown;
}

std::string TextTable::text(int width) const {
  const std::vector<int> wide = widths();
  const std::vector<bool> seen = shown(wide, width);
  std::string text, left_out;
  const auto line = [&](auto&& cell_of) {
    std::string row(static_cast<std::size_t>(indent_), ' ');
    bool first = true;
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      if (!seen[c]) continue;
      if (!std::exchange(first, false)) row += std::string(gap, ' ');
      row += padded(cell_of(c), columns_[c].align, wide[c]);
    }
    end_line(text, std::move(row));
  };
  line([&](std::size_t c) { return columns_[c].heading; });
  if (std::ranges::any_of(columns_, [](const TextColumn& c) { return !c.unit.empty(); }))
    line([&](std::size_t c) { return columns_[c].unit; });
  for (const Row& row : rows_) {
    if (row.cells.empty())
      text += row.line + '\n';
    else
      line([&](std::size_t c) { return row.cells[c]; });
  }
  for (std::size_t c = 0; c < columns_.size(); ++c)
    if (!seen[c]) left_out += (left_out.empty() ? "" : ", ") + columns_[c].heading;
  if (!left_out.empty()) text += "--wide also shows: " + left_out + "\n";
  return text;
}

}  // namespace validate
