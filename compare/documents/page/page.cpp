#include "compare/documents/page/page.hpp"

#include <fmt/core.h>

#include <cstdint>

#include "compare/base/sha256.hpp"
#include "compare/documents/bytes/base64.hpp"
#include "compare/documents/bytes/html.hpp"
#include "compare/documents/page/assets.hpp"

namespace validate {
namespace {

/// JSON in which no text can end the element that holds it: < stands in texts alone.
std::string within_script(std::string_view json) {
  std::string safe;
  safe.reserve(json.size());
  for (const char c : json) {
    if (c == '<')
      safe += "\\u003c";
    else
      safe += c;
  }
  return safe;
}

/// What a content security policy calls this script.
std::string fingerprint(std::string_view script) {
  const std::string digits = sha256(script);
  std::string bytes;
  for (std::size_t i = 0; i < digits.size(); i += 2)
    bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
  return "sha256-" + base64(bytes);
}

}  // namespace

std::string page(std::string_view title, std::string_view body, std::string_view data) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
      "style-src 'unsafe-inline'; script-src '{}'; base-uri 'none'; form-action 'none'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n{}</main>\n"
      "<script type=\"application/json\" id=\"data\">{}</script>\n<script>{}</script>\n</body>\n</html>\n",
      fingerprint(page_script), html::escaped(title), page_style, body, data.empty() ? "{}" : within_script(data),
      page_script);
}

}  // namespace validate
