#include "compare/documents/texts/verify_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "compare/base/errors.hpp"
#include "compare/documents/texts/text_table.hpp"

namespace validate {
namespace {

/// Counts where values have to be equal; a bound has none.
std::string of_equals(const VerificationRow& row, double value) {
  return row.relation == Relation::equal ? fmt::format("{:.1e}", value) : "";
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + '"';
}

}  // namespace

std::string basis_text(const std::vector<VerificationRow>& rows) {
  const Result result = verification_result(rows);
  return fmt::format(
      "\n{} rows: {} rest on numbers from outside (closed forms, publications, codes written separately), {} check "
      "the code against itself\n",
      rows.size(), result.outside, result.itself);
}

std::string verification_text(const std::vector<VerificationRow>& rows, int width) {
  TextTable table({{.heading = "", .align = Align::left},
                   {.heading = "group", .align = Align::left, .rank = 3},
                   {.heading = "case", .align = Align::left},
                   {.heading = "quantity", .align = Align::left},
                   {.heading = "computed"},
                   {.heading = ""},
                   {.heading = "reference"},
                   {.heading = "error", .rank = 1},
                   {.heading = "allowed", .rank = 2},
                   {.heading = "origin", .align = Align::left, .rank = 4}});
  for (const VerificationRow& row : rows)
    table.add({row.pass ? "ok" : "FAIL", row.group, row.name, row.quantity, fmt::format("{:.9g}", row.computed),
               fmt::format("{}", row.relation), fmt::format("{:.9g}", row.reference),
               of_equals(row, row.relative_error), of_equals(row, row.tolerance),
               row.origin + (row.note.empty() ? "" : " (" + row.note + ")")});
  return table.text(width) + basis_text(rows);
}

std::string verification_csv(const std::vector<VerificationRow>& rows) {
  std::string text = "group,name,quantity,ours,relation,published,source,basis,relative_error,tolerance,pass,note\n";
  for (const VerificationRow& row : rows)
    text += fmt::format("{},{},{},{:.12g},{},{:.12g},{},{},{:.3e},{:.3e},{},{}\n", row.group, quoted(row.name),
                        quoted(row.quantity), row.computed, row.relation, row.reference, quoted(row.origin), row.basis,
                        row.relative_error, row.tolerance, row.pass, quoted(row.note));
  return text;
}

Result verification_result(std::vector<VerificationRow> rows) {
  Result result;
  result.command = Command::verify;
  result.rows = std::move(rows);
  result.passed = static_cast<int>(std::ranges::count_if(result.rows, &VerificationRow::pass));
  result.failed = static_cast<int>(result.rows.size()) - result.passed;
  result.outside = static_cast<int>(std::ranges::count(result.rows, Basis::outside, &VerificationRow::basis));
  result.itself = static_cast<int>(result.rows.size()) - result.outside;
  if (result.failed == 0) return result;
  result.exit_code = static_cast<int>(ExitCode::disagreement);
  result.exit_reason = fmt::format("{} of {} rows fail", result.failed, result.rows.size());
  return result;
}

}  // namespace validate
