#include "compare/instruments/table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "compare/base/errors.hpp"
#include "compare/instruments/text.hpp"

namespace validate {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t lines_looked_at = 400;

struct Form {
  char separator, decimal;
};
constexpr std::array forms = {Form{'\t', '.'}, Form{'\t', ','}, Form{';', '.'}, Form{';', ','},
                              Form{',', '.'},  Form{' ', '.'},  Form{' ', ','}};

bool is_comment(std::string_view line) {
  return line.starts_with('#') || line.starts_with('%') || line.starts_with('!') || line.starts_with("//") ||
         line.starts_with("\"#");
}

std::string_view comment_of(std::string_view line) {
  const auto from = line.find_first_not_of("#%!/\" \t");
  return from == std::string_view::npos ? std::string_view() : line.substr(from);
}

/// NaN for a cell that says that there is no value; nothing for one that is neither that nor a number.
std::optional<double> value_of(std::string_view cell, char decimal) {
  if (cell.empty() || cell == "-" || cell == "--" || cell == "#N/A" || cell == "NA" || cell == "n/a" || cell == "null")
    return no_value;
  const auto value = number_of(cell, decimal);
  return value && !std::isfinite(*value) ? no_value : value;
}

/// Number of cells of a row of numbers; 0 for any other line.
std::size_t row_length(std::string_view line, const Form& form) {
  const auto cells = cells_of(line, form.separator);
  bool number = false;
  for (const std::string_view cell : cells) {
    const auto value = value_of(cell, form.decimal);
    if (!value) return 0;
    number = number || std::isfinite(*value) || !cell.empty();
  }
  return number && cells.size() > 1 ? cells.size() : 0;
}

/// The form under which most lines are rows, and a column of an empty last cell counted off.
std::optional<Form> form_of(const std::vector<TextLine>& lines) {
  std::optional<Form> best;
  std::size_t most = 0;
  for (const Form& form : forms) {
    std::size_t rows = 0, looked_at = 0;
    for (const TextLine& line : lines) {
      const std::string_view content = trimmed(line.text);
      if (content.empty() || is_comment(content)) continue;
      rows += row_length(line.text, form) > 0 ? 1 : 0;
      if (rows > 0 && ++looked_at == lines_looked_at) break;
    }
    if (rows > most) most = rows, best = form;
  }
  return best;
}

void remark(TextTable& table, std::string_view line) {
  const std::string_view content = comment_of(line);
  auto end = content.find(':');
  if (end == std::string_view::npos) end = content.find('=');
  if (end == std::string_view::npos) return;
  table.remarks.emplace(lower_case(trimmed(content.substr(0, end))), trimmed(content.substr(end + 1)));
}

bool all_units(const std::vector<std::string_view>& cells) {
  bool some = false;
  for (std::string_view cell : cells) {
    while (!cell.empty() && (cell.front() == '(' || cell.front() == '[')) cell = cell.substr(1);
    while (!cell.empty() && (cell.back() == ')' || cell.back() == ']')) cell.remove_suffix(1);
    if (cell.empty() || cell == "-" || cell == "1") continue;
    if (!si_unit(cell)) return false;
    some = true;
  }
  return some;
}

/// A line of as many names as the first row has not got.
void refuse_other_length(const TextTable& table, const std::vector<TextLine>& above, const TextLine& row,
                         std::size_t columns, const std::string& label) {
  if (!table.headings.empty() || table.separator == ' ' || above.empty() || is_comment(trimmed(above.back().text)))
    return;
  const std::size_t names = cells_of(above.back().text, table.separator).size();
  if (names > 1) throw bad_input("{}:{}: {} cells where the header has {}", label, row.number, columns, names);
}

/// What stands above the rows: the lines from the last to the first that can name the columns.
void read_header(TextTable& table, const std::vector<TextLine>& above, std::size_t columns) {
  const auto take = [&](const TextLine& line, std::string_view content) {
    auto cells = cells_of(content, table.separator);
    if (cells.size() != columns && table.separator != ' ') cells = cells_of(content, ' ');
    if (cells.size() != columns) return false;
    std::vector<std::string> texts(cells.begin(), cells.end());
    if (table.units.empty() && all_units(cells)) {
      table.units = std::move(texts);
      return false;
    }
    table.headings = std::move(texts);
    table.header_line = line.number;
    return true;
  };
  for (const bool comments : {false, true})
    for (auto line = above.rbegin(); line != above.rend(); ++line) {
      const std::string_view content = trimmed(line->text);
      if (content.empty() || is_comment(content) != comments) continue;
      if (take(*line, comments ? comment_of(content) : line->text)) return;
    }
  table.units.clear();
}

void read_row(TextTable& table, const TextLine& line, const std::string& label) {
  const auto cells = cells_of(line.text, table.separator);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const auto value = value_of(cells[c], table.decimal);
    const std::string column = c < table.headings.size() ? table.headings[c] : fmt::format("{}", c + 1);
    if (c < table.columns.size()) {
      if (!value)
        throw bad_input("{}:{}: '{}' in column '{}' is not a number", label, line.number, printable(cells[c]),
                        printable(column));
      table.columns[c].push_back(*value);
    } else if (!cells[c].empty()) {
      throw bad_input("{}:{}: {} cells where the header has {}", label, line.number, cells.size(),
                      table.columns.size());
    }
  }
  if (cells.size() < table.columns.size())
    throw bad_input("{}:{}: {} cells where the header has {}", label, line.number, cells.size(), table.columns.size());
  table.lines.push_back(line.number);
}

}  // namespace

bool has_table(std::string_view utf8) { return form_of(lines_of(utf8)).has_value(); }

TextTable read_text_table(std::string_view utf8, const std::string& label) {
  const std::vector<TextLine> lines = lines_of(utf8);
  const auto form = form_of(lines);
  if (!form)
    throw bad_input("{}: no rows of at least two numbers, separated by tabs, semicolons, commas or blanks", label);
  TextTable table;
  table.separator = form->separator;
  table.decimal = form->decimal;
  std::vector<TextLine> above;
  for (const TextLine& line : lines) {
    const std::string_view content = trimmed(line.text);
    const bool comment = is_comment(content);
    if (content.empty()) continue;
    const std::size_t length = comment || !table.columns.empty() ? 0 : row_length(line.text, *form);
    if (length > 0) {
      const bool empty_end = cells_of(line.text, form->separator).back().empty();
      table.columns.resize(length);
      read_header(table, above, length);
      if (table.headings.empty() && empty_end) {
        table.columns.resize(length - 1);
        read_header(table, above, length - 1);
      }
      refuse_other_length(table, above, line, length, label);
    }
    if (comment || table.columns.empty()) {
      remark(table, content);
      if (table.columns.empty()) above.push_back(line);
    } else {
      read_row(table, line, label);
    }
  }
  return table;
}

}  // namespace validate
