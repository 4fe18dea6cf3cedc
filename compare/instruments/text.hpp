// Text that comes from anywhere: lines, cells, numbers and encodings.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace validate {

struct TextLine {
  int number;  ///< from 1
  std::string_view text;
};

/// Lines ended by LF, CR LF or CR, without their ends. Views into the text.
std::vector<TextLine> lines_of(std::string_view text);
std::vector<TextLine> lines_of(std::string&& text) = delete;  // they would outlive it

std::string_view trimmed(std::string_view text);  ///< without blanks, tabs, CR and quotes around it

/// Cells between separators; a separator of ' ' is any run of blanks and tabs.
std::vector<std::string_view> cells_of(std::string_view line, char separator);
std::vector<std::string_view> cells_of(std::string&& line, char separator) = delete;  // its cells would outlive it

/// A number alone, with '.' (or `decimal`) and an optional '+' before it; nan and inf are numbers.
std::optional<double> number_of(std::string_view text, char decimal = '.');

void append_utf8(std::string& text, unsigned code_point);

/// UTF-8 of a text in UTF-8 (with or without a byte order mark), UTF-16 with one, or else Latin-1.
std::string to_utf8(std::string_view bytes);

/// At most 60 characters of a text, none of which moves a terminal's cursor: for messages.
std::string printable(std::string_view text);

/// Whether bytes look like text: hardly any control character, no zero.
bool is_text(std::string_view bytes);

std::string lower_case(std::string_view text);

/// What a unit is in SI: factor · unit. "nN" is 1e-9 · N.
struct SiUnit {
  double factor;
  std::string unit;  ///< m, N, s, V, A, N/m, m/V, m/s, Hz
};

/// Nothing for what is no unit. Micro as µ, μ or u; "~m" is NanoScope's.
std::optional<SiUnit> si_unit(std::string_view text);

}  // namespace validate
