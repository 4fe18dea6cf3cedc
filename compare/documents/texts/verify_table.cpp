#include "compare/documents/texts/verify_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "compare/base/errors.hpp"

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

std::string verification_text(const std::vector<VerificationRow>& rows) {
  std::size_t widest_case = 4, widest_quantity = 8;
  for (const VerificationRow& row : rows) {
    widest_case = std::max(widest_case, row.name.size());
    widest_quantity = std::max(widest_quantity, row.quantity.size());
  }
  std::string text =
      fmt::format("{:4} {:9} {:{}} {:{}} {:>15}    {:>15} {:>8} {:>8}  {}\n", "", "group", "case", widest_case,
                  "quantity", widest_quantity, "computed", "reference", "error", "allowed", "origin");
  for (const VerificationRow& row : rows)
    text += fmt::format("{:4} {:9} {:{}} {:{}} {:>15.9g} {:>2} {:>15.9g} {:>8} {:>8}  {}{}\n", row.pass ? "ok" : "FAIL",
                        row.group, row.name, widest_case, row.quantity, widest_quantity, row.computed, row.relation,
                        row.reference, of_equals(row, row.relative_error), of_equals(row, row.tolerance), row.origin,
                        row.note.empty() ? "" : " (" + row.note + ")");
  return text + basis_text(rows);
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
