// How wide what is printed may be.
#pragma once

#include <string>
#include <string_view>

namespace validate {

/// Characters in a line of stdout: COLUMNS or the terminal's own width; 80 where there is none, and at most 80 where
/// stdout is no terminal. Not less than 40. After print_wide() there is no limit.
int line_width();

/// Of stderr, for lines that are kept up to date.
int remark_width();

/// From here on everything that a table has is printed, however wide (--wide).
void print_wide();
bool is_printed_wide();

/// Characters, not bytes.
int width_of(std::string_view text);

/// Lines longer than `width` broken at blanks, their further lines indented by four more than the first, or to where
/// its second column begins. What has no blank (a path) stays whole.
std::string wrapped(std::string_view text, int width);

/// A text for readers, to stdout: wrapped to the line's width.
void print_text(std::string_view text);

/// The beginning of a line that fits into `width`, with an ellipsis where something was cut off.
std::string cut_to(std::string_view line, int width);

}  // namespace validate
