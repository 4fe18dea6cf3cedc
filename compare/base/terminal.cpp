#include "compare/base/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <limits>
#include <optional>

#include "compare/base/standard_streams.hpp"

namespace validate {
namespace {

constexpr int usual_width = 80, smallest_width = 40;

bool wide = false;

bool continues(char c) { return (c & 0xC0) == 0x80; }

std::optional<int> columns_variable() {
  const char* const text = std::getenv("COLUMNS");
  if (!text) return std::nullopt;
  const std::string_view view = text;
  int columns = 0;
  const auto [end, problem] = std::from_chars(view.data(), view.data() + view.size(), columns);
  if (problem != std::errc{} || end != view.data() + view.size() || columns <= 0) return std::nullopt;
  return columns;
}

int width_of_stream(int descriptor) {
  const bool terminal = ::isatty(descriptor) == 1;
  int width = columns_variable().value_or(0);
  if (winsize size{}; width == 0 && terminal && ::ioctl(descriptor, TIOCGWINSZ, &size) == 0) width = size.ws_col;
  if (width == 0) width = usual_width;
  return std::max(smallest_width, terminal ? width : std::min(width, usual_width));
}

/// The byte after the last of `count` characters.
std::size_t after(std::string_view text, int count) {
  std::size_t at = 0;
  while (at < text.size() && count > 0) {
    ++at;
    while (at < text.size() && continues(text[at])) ++at;
    --count;
  }
  return at;
}

std::string_view without_end_blanks(std::string_view text) {
  const auto last = text.find_last_not_of(' ');
  return last == std::string_view::npos ? std::string_view() : text.substr(0, last + 1);
}

/// Where a text is broken so that its first part has at most `width` characters: at a blank, at the next one where
/// the first word is longer; npos where there is none.
std::size_t break_of(std::string_view text, int width, std::size_t first_word) {
  const std::size_t limit = after(text, width);
  const std::size_t before = text.rfind(' ', limit);
  return before != std::string_view::npos && before > first_word ? before : text.find(' ', std::max(limit, first_word));
}

/// How far a line's further lines are indented: to what stands behind its first gap of two blanks or more, else by four
/// more than itself.
std::size_t indent_of(std::string_view line, std::size_t first_word, int width) {
  const std::size_t gap = line.find("  ", first_word);
  const std::size_t second = gap == std::string_view::npos ? gap : line.find_first_not_of(' ', gap);
  const auto half = static_cast<std::size_t>(width) / 2;
  if (second != std::string_view::npos) {
    const auto column = static_cast<std::size_t>(width_of(line.substr(0, second)));
    if (column <= half) return column;
  }
  return std::min(first_word + 4, half);
}

void add_wrapped(std::string& result, std::string_view line, int width) {
  const std::size_t first_word = line.find_first_not_of(' ');
  if (first_word == std::string_view::npos) return;
  const std::string indent(indent_of(line, first_word, width), ' ');
  int left = width;
  for (std::size_t word = first_word; width_of(line) > left; word = 0) {
    const std::size_t at = break_of(line, left, word);
    if (at == std::string_view::npos) break;
    result += without_end_blanks(line.substr(0, at));
    line.remove_prefix(std::min(line.find_first_not_of(' ', at), line.size()));
    if (line.empty()) return;
    result += '\n' + indent;
    left = width - static_cast<int>(indent.size());
  }
  result += line;
}

}  // namespace

void print_wide() { wide = true; }
bool is_printed_wide() { return wide; }

int line_width() { return wide ? std::numeric_limits<int>::max() : width_of_stream(STDOUT_FILENO); }
int remark_width() { return width_of_stream(STDERR_FILENO); }

int width_of(std::string_view text) {
  return static_cast<int>(std::ranges::count_if(text, [](char c) { return !continues(c); }));
}

std::string wrapped(std::string_view text, int width) {
  std::string result;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    add_wrapped(result, text.substr(0, end), width);
    if (end < text.size()) result += '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

void print_text(std::string_view text) { print_result(wrapped(text, line_width())); }

std::string cut_to(std::string_view line, int width) {
  if (width_of(line) <= width) return std::string(line);
  return std::string(line.substr(0, after(line, width - 1))) + "…";
}

}  // namespace validate
