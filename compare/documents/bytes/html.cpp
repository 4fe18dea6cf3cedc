#include "compare/documents/bytes/html.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "compare/documents/bytes/base64.hpp"

namespace validate::html {
namespace {

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string preformatted(std::string_view text) { return "<pre>" + escaped(text) + "</pre>\n"; }

std::string table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows,
                  const std::vector<std::size_t>& columns_of_words) {
  const auto cells = [&](const std::string& start, const std::vector<std::string>& row, const std::string& end) {
    std::string text = "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const bool words = std::ranges::find(columns_of_words, i) != columns_of_words.end();
      text += start + (words ? " class=\"text\">" : ">") + escaped(row[i]) + end;
    }
    return text + "</tr>\n";
  };
  std::string text =
      "<div class=\"wide\"><table>\n<thead>" + cells("<th scope=\"col\"", header, "</th>") + "</thead>\n<tbody>\n";
  for (const auto& row : rows) text += cells("<td", row, "</td>");
  return text + "</tbody></table></div>\n";
}

std::string inline_svg(std::string svg, std::string_view prefix, std::string_view title) {
  const auto start = svg.find("<svg");
  if (start == std::string::npos) return {};
  svg.erase(0, start);
  replace_all(svg, " id=\"", fmt::format(" id=\"{}", prefix));
  replace_all(svg, " id='", fmt::format(" id='{}", prefix));
  replace_all(svg, "href='#", fmt::format("href='#{}", prefix));
  replace_all(svg, "href=\"#", fmt::format("href=\"#{}", prefix));
  replace_all(svg, "url(#", fmt::format("url(#{}", prefix));
  const auto from = svg.find("<title>"), to = svg.find("</title>");
  if (from != std::string::npos && to != std::string::npos) svg.replace(from, to - from, "<title>" + escaped(title));
  return svg;
}

std::string inline_png(std::string_view bytes, std::string_view title) {
  return fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\">", escaped(title), base64(bytes));
}

}  // namespace validate::html
