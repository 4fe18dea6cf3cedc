#include "compare/documents/texts/many_csv.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "compare/base/units.hpp"

namespace validate {
namespace {

struct LabUnit {
  std::string_view name;
  double factor = 1;
};

LabUnit lab_unit(std::string_view base) {
  if (base == unit::length) return {"_nm", 0.1};
  if (base == unit::force) return {"_nN", nN_per_eV_per_A};
  if (base == unit::membrane_force) return {"_N_per_m", N_per_m_per_eV_per_A2};
  if (base == unit::nanometre) return {"_nm"};
  if (base == unit::nanonewton) return {"_nN"};
  if (base == unit::newton_per_metre) return {"_N_per_m"};
  if (base == unit::energy) return {"_eV"};
  return {""};
}

/// In quotes where a separator is in it.
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c == '\n' || c == '\r' ? ' ' : c);
  return quoted + "\"";
}

std::vector<std::string> cells_of_line(std::string_view line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
      cells.back() += line[i++];
    } else if (line[i] == '"') {
      quoted = !quoted;
    } else if (line[i] == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += line[i];
    }
  }
  if (quoted) throw std::invalid_argument("a quote without an end");
  return cells;
}

template <class Number>
Number number_of(const std::string& text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) throw std::invalid_argument(text);
  return value;
}

}  // namespace

std::string many_csv_header() {
  std::string text;
  const CurveRow none;
  describe(none, [&](const Field& field, const auto&) {
    text += fmt::format("{}{}{}", text.empty() ? "" : ",", field.name, lab_unit(field.unit).name);
  });
  return text;
}

std::string many_csv_row(const CurveRow& row) {
  std::string text;
  const auto add = [&](const std::string& value) { text += (text.empty() ? "" : ",") + value; };
  describe(row, [&](const Field& field, const auto& value) {
    using Value = std::remove_cvref_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, std::string>)
      add(cell(value));
    else if constexpr (std::is_same_v<Value, int>)
      add(std::to_string(value));
    else
      add(std::isfinite(value) ? fmt::format("{:.10g}", value * lab_unit(field.unit).factor) : "");
  });
  return text;
}

CurveRow many_csv_read(std::string_view line) {
  const std::vector<std::string> cells = cells_of_line(line);
  CurveRow row;
  std::size_t at = 0;
  describe(row, [&](const Field& field, auto& value) {
    using Value = std::remove_cvref_t<decltype(value)>;
    if (at == cells.size()) throw std::invalid_argument("too few cells");
    const std::string& text = cells[at++];
    if constexpr (std::is_same_v<Value, std::string>)
      value = text;
    else if constexpr (std::is_same_v<Value, int>)
      value = number_of<int>(text);
    else
      value = text.empty() ? not_known : number_of<double>(text) / lab_unit(field.unit).factor;
  });
  if (at != cells.size()) throw std::invalid_argument("too many cells");
  return row;
}

}  // namespace validate
