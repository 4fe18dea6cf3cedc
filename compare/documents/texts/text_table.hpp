// A table for readers: columns as wide as their cells, those of less weight left out where the line is too short.
#pragma once

#include <string>
#include <vector>

namespace validate {

/// Of lines where nobody says how wide they may be.
inline constexpr int widest_line = 120;

enum class Align { left, right };

struct TextColumn {
  std::string heading, unit = {};
  Align align = Align::right;
  int rank = 0;  ///< the largest goes first where the line is too short; those of 0 stay
};

class TextTable {
 public:
  explicit TextTable(std::vector<TextColumn> columns, int indent = 0);

  /// A cell a column; less cells leave the rest empty.
  void add(std::vector<std::string> cells);
  /// A line between the rows, across all columns.
  void add_line(std::string line);

  /// Lines of at most `width` characters as far as leaving columns out reaches that; what was left out is named below.
  std::string text(int width) const;

 private:
  struct Row {
    std::vector<std::string> cells;
    std::string line = {};
  };
  std::vector<bool> shown(const std::vector<int>& widths, int width) const;
  std::vector<int> widths() const;

  std::vector<TextColumn> columns_;
  std::vector<Row> rows_;
  int indent_;
};

}  // namespace validate
