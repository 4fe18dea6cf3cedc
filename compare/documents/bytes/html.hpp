// Small pieces of HTML.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace validate::html {

/// Text with the characters that HTML reads as markup replaced.
std::string escaped(std::string_view text);

/// Text whose lines and blanks stay as they are.
std::string preformatted(std::string_view text);

/// A table; cells are text, not markup. Cells from the second column on are set as numbers, but for the columns that
/// are said to hold words.
std::string table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows,
                  const std::vector<std::size_t>& columns_of_words = {});

/// A gnuplot SVG ready to stand inside a page: no prolog, scalable, its ids prefixed so that several do not
/// collide.
std::string inline_svg(std::string svg, std::string_view prefix, std::string_view title);

/// A picture inside the page: the PNG's bytes as a data URI.
std::string inline_png(std::string_view bytes, std::string_view title);

}  // namespace validate::html
