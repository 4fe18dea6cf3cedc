#include "compare/documents/texts/verify_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compare/base/errors.hpp"

namespace validate::verify {
namespace {

const char* relation_text(Relation relation) {
  switch (relation) {
    case Relation::at_most:
      return "<=";
    case Relation::at_least:
      return ">=";
    case Relation::equal:
      break;
  }
  return "=";
}

/// The error counts where values have to be equal; a bound has none.
std::string error_text(const Row& row) {
  return row.relation == Relation::equal ? fmt::format("{:.1e}", relative_error(row)) : "";
}

std::string tolerance_text(const Row& row) {
  return row.relation == Relation::equal ? fmt::format("{:.1e}", row.tolerance) : "";
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + '"';
}

}  // namespace

std::string table_text(const std::vector<Row>& rows) {
  std::size_t widest_case = 4, widest_quantity = 8;
  for (const Row& row : rows) {
    widest_case = std::max(widest_case, row.name.size());
    widest_quantity = std::max(widest_quantity, row.quantity.size());
  }
  std::string text =
      fmt::format("{:4} {:9} {:{}} {:{}} {:>15}    {:>15} {:>8} {:>8}  {}\n", "", "group", "case", widest_case,
                  "quantity", widest_quantity, "computed", "reference", "error", "allowed", "origin");
  for (const Row& row : rows)
    text += fmt::format("{:4} {:9} {:{}} {:{}} {:>15.9g} {:>2} {:>15.9g} {:>8} {:>8}  {}{}\n",
                        passes(row) ? "ok" : "FAIL", row.group, row.name, widest_case, row.quantity, widest_quantity,
                        row.computed, relation_text(row.relation), row.reference.value, error_text(row),
                        tolerance_text(row), row.reference.origin, row.note.empty() ? "" : " (" + row.note + ")");
  return text;
}

std::string table_csv(const std::vector<Row>& rows) {
  std::string text = "group,case,quantity,computed,relation,reference,origin,relative_error,tolerance,pass,note\n";
  for (const Row& row : rows)
    text +=
        fmt::format("{},{},{},{:.12g},{},{:.12g},{},{:.3e},{:.3e},{},{}\n", row.group, quoted(row.name),
                    quoted(row.quantity), row.computed, relation_text(row.relation), row.reference.value,
                    quoted(row.reference.origin), relative_error(row), row.tolerance, passes(row), quoted(row.note));
  return text;
}

Result verification_result(const std::vector<Row>& rows) {
  Result result;
  result.command = Command::verify;
  for (const Row& row : rows) {
    result.rows.push_back({row.group, row.name, row.quantity, row.computed, relation_text(row.relation),
                           row.reference.value, row.reference.origin, relative_error(row), row.tolerance, passes(row),
                           row.note});
    (passes(row) ? result.passed : result.failed) += 1;
  }
  if (result.failed == 0) return result;
  result.exit_code = static_cast<int>(ExitCode::disagreement);
  result.exit_reason = fmt::format("{} of {} rows fail", result.failed, rows.size());
  return result;
}

}  // namespace validate::verify
