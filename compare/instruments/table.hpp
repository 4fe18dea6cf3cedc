// A table of numbers in a text: its separator, decimal sign, header and units are found out.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace validate {

struct TextTable {
  char separator = ',', decimal = '.';
  std::vector<std::string> headings;           ///< one a column; empty where the file has no header
  std::vector<std::string> units;              ///< of a row of units below it; empty where there is none
  int header_line = 0;                         ///< 0: none
  std::vector<int> lines;                      ///< number of each row's line
  std::vector<std::vector<double>> columns;    ///< equally long; NaN where a cell is empty or says so
  std::map<std::string, std::string> remarks;  ///< `key: value` or `key=value` of comments and of lines above the table
};

/// Whether some lines of a text are rows of at least two numbers.
bool has_table(std::string_view utf8);

/// Comments begin with #, %, ! or //; lines above the table are remarks. The header is the line above the first row
/// that has as many cells, or else the last such comment; a row of units may stand between. Throws Error (bad input),
/// which `label` starts, with the line: no rows of numbers, a row of another length, a cell that is not a number.
TextTable read_text_table(std::string_view utf8, const std::string& label);

}  // namespace validate
