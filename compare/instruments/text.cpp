#include "compare/instruments/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace validate {
namespace {

constexpr std::string_view blanks = " \t\r\n\"";

/// Length of a valid UTF-8 sequence at the start of a text; 0 where there is none.
std::size_t sequence_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  const std::size_t length = first < 0x80                    ? 1
                             : first >= 0xC2 && first < 0xE0 ? 2
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0u) != 0x80) return 0;
  return length;
}

std::string from_utf16(std::string_view bytes, bool little) {
  std::string text;
  const auto unit_at = [&](std::size_t i) {
    const auto low = static_cast<unsigned char>(bytes[i + (little ? 0 : 1)]);
    const auto high = static_cast<unsigned char>(bytes[i + (little ? 1 : 0)]);
    return static_cast<unsigned>(low) | static_cast<unsigned>(high) << 8;
  };
  for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
    const unsigned first = unit_at(i);
    if (first >= 0xD800 && first < 0xDC00 && i + 3 < bytes.size()) {
      const unsigned second = unit_at(i + 2);
      if (second >= 0xDC00 && second < 0xE000) {
        append_utf8(text, 0x10000 + ((first - 0xD800) << 10) + (second - 0xDC00));
        i += 2;
        continue;
      }
    }
    append_utf8(text, first);
  }
  return text;
}

/// Both micro signs and NanoScope's ~ as u, exponents and products plain, no blanks.
std::string plain_unit(std::string_view text) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 6> spellings = {
      {{"\u00b5", "u"}, {"\u03bc", "u"}, {"~", "u"}, {" ", ""}, {"_per_", "/"}, {"\u00c5", "A_ngstrom"}}};
  std::string plain(trimmed(text));
  for (const auto& [from, to] : spellings)
    for (auto at = plain.find(from); at != std::string::npos; at = plain.find(from, at + to.size()))
      plain.replace(at, from.size(), to);
  return plain;
}

constexpr std::array<std::pair<char, double>, 9> prefixes = {{{'f', 1e-15},
                                                              {'p', 1e-12},
                                                              {'n', 1e-9},
                                                              {'u', 1e-6},
                                                              {'m', 1e-3},
                                                              {'c', 1e-2},
                                                              {'k', 1e3},
                                                              {'M', 1e6},
                                                              {'G', 1e9}}};

std::optional<SiUnit> simple_unit(std::string_view text) {
  for (const std::string_view base : {"m", "N", "s", "V", "A", "Hz"})
    if (text == base) return SiUnit{1, std::string(base)};
  if (text == "sec") return SiUnit{1, "s"};
  if (text == "A_ngstrom" || text == "Angstrom" || text == "angstrom") return SiUnit{1e-10, "m"};
  if (text.size() < 2) return std::nullopt;
  for (const auto& [prefix, factor] : prefixes) {
    if (text.front() != prefix) continue;
    for (const std::string_view base : {"m", "N", "s", "V", "A", "Hz"})
      if (text.substr(1) == base) return SiUnit{factor, std::string(base)};
  }
  return std::nullopt;
}

}  // namespace

std::vector<TextLine> lines_of(std::string_view text) {
  std::vector<TextLine> lines;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", from), text.size());
    lines.push_back({static_cast<int>(lines.size()) + 1, text.substr(from, end - from)});
    from = end + (text.substr(end, 2) == "\r\n" ? 2 : 1);
  }
  return lines;
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string_view> cells_of(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  if (separator == ' ') {
    for (auto from = line.find_first_not_of(" \t"); from != std::string_view::npos;) {
      const auto end = std::min(line.find_first_of(" \t", from), line.size());
      cells.push_back(trimmed(line.substr(from, end - from)));
      from = line.find_first_not_of(" \t", end);
    }
    return cells;
  }
  for (std::size_t from = 0; from <= line.size();) {
    const bool quoted = from < line.size() && line[from] == '"';
    const std::size_t closing = quoted ? line.find('"', from + 1) : std::string_view::npos;
    const std::size_t end =
        std::min(line.find(separator, closing == std::string_view::npos ? from : closing), line.size());
    cells.push_back(trimmed(line.substr(from, end - from)));
    from = end + 1;
  }
  return cells;
}

std::optional<double> number_of(std::string_view text, char decimal) {
  text = trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  if (text.empty() || text.size() > 64) return std::nullopt;
  std::array<char, 64> copy{};
  std::ranges::transform(text, copy.begin(), [decimal](char c) { return c == decimal ? '.' : c; });
  double value = 0;
  const auto [end, error] = std::from_chars(copy.data(), copy.data() + text.size(), value);
  if (error == std::errc::result_out_of_range || error != std::errc{} || end != copy.data() + text.size())
    return std::nullopt;
  return value;
}

void append_utf8(std::string& text, unsigned code) {
  if (code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) code = 0xFFFD;
  const auto add = [&text](unsigned byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
  if (code < 0x80) {
    add(code);
  } else if (code < 0x800) {
    add(0xC0 | code >> 6), add(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    add(0xE0 | code >> 12), add(0x80 | (code >> 6 & 0x3F)), add(0x80 | (code & 0x3F));
  } else {
    add(0xF0 | code >> 18), add(0x80 | (code >> 12 & 0x3F)), add(0x80 | (code >> 6 & 0x3F)), add(0x80 | (code & 0x3F));
  }
}

std::string to_utf8(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE")) return from_utf16(bytes, true);
  if (bytes.starts_with("\xFE\xFF")) return from_utf16(bytes, false);
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t length = sequence_length(bytes.substr(at));
    if (length == 0) {
      std::string text;
      for (const char c : bytes) append_utf8(text, static_cast<unsigned char>(c));
      return text;
    }
    at += length;
  }
  return std::string(bytes);
}

std::string printable(std::string_view text) {
  constexpr std::size_t most = 60;
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    if (result.size() >= most) return result + "…";
    const std::size_t length = sequence_length(text.substr(at));
    const auto first = static_cast<unsigned char>(text[at]);
    const bool control = first < 0x20 || first == 0x7F ||
                         (first == 0xC2 && length == 2 && static_cast<unsigned char>(text[at + 1]) < 0xA0);
    if (length == 0 || control) {
      result += '?';
      at += std::max<std::size_t>(length, 1);
      continue;
    }
    result += text.substr(at, length);
    at += length;
  }
  return result;
}

bool is_text(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) return true;
  const std::string_view head = bytes.substr(0, 65536);
  const auto odd = std::ranges::count_if(head, [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 && c != '\n' && c != '\r' && c != '\t' && c != '\f';
  });
  return !head.empty() && head.find('\0') == std::string_view::npos &&
         odd * 200 <= static_cast<std::ptrdiff_t>(head.size());
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return lower;
}

std::optional<SiUnit> si_unit(std::string_view text) {
  const std::string plain = plain_unit(text);
  const auto slash = plain.find('/');
  if (slash == std::string::npos) return simple_unit(plain);
  const auto above = simple_unit(std::string_view(plain).substr(0, slash)),
             below = simple_unit(std::string_view(plain).substr(slash + 1));
  if (!above || !below) return std::nullopt;
  return SiUnit{above->factor / below->factor, above->unit + "/" + below->unit};
}

}  // namespace validate
