#include "compare/documents/texts/published_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace validate {
namespace {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + '"';
}

std::string number_or_nothing(const std::optional<double>& value) {
  return value ? fmt::format("{:.6g}", *value) : std::string();
}

std::string unit_behind(const PublishedRow& row) { return row.unit == "1" ? "" : " " + row.unit; }

std::string published_number(const PublishedRow& row) {
  const std::string relation = row.relation == Relation::equal ? "" : fmt::format("{} ", row.relation);
  const std::string spread = row.uncertainty ? fmt::format(" ± {:.6g}", *row.uncertainty) : "";
  return fmt::format("{}{:.6g}{}{}", relation, row.published, spread, unit_behind(row));
}

/// What the published number and ours say together.
std::string verdict(const PublishedRow& row) {
  if (const auto bound = holds(row)) return *bound ? "holds" : "does not hold";
  std::string text;
  if (const auto relative = difference(row)) text = fmt::format("{:+8.2f} %", 100 * *relative);
  if (const auto z = z_score(row)) text += fmt::format("   z = {:+.1f}", *z);
  return text;
}

std::string heading(const PublishedRow& row) {
  std::string text = fmt::format("{}: {}\n  {}; {}\n", row.name, published_number(row), row.source, row.conditions);
  if (!row.comparable) text += fmt::format("  not comparable: {}\n", row.reason);
  return text;
}

bool same_number(const PublishedRow& a, const PublishedRow& b) {
  return a.name == b.name && a.quantity == b.quantity && a.source == b.source && a.published == b.published;
}

}  // namespace

std::string published_text(const std::vector<PublishedRow>& rows) {
  std::size_t widest = 8;
  for (const PublishedRow& row : rows) widest = std::max(widest, row.of.size());
  std::string text;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i == 0 || !same_number(rows[i - 1], rows[i])) text += (i ? "\n" : "") + heading(rows[i]);
    text += fmt::format("    {:{}} {:>12.6g}{}   {}\n", rows[i].of, widest, rows[i].ours, unit_behind(rows[i]),
                        verdict(rows[i]));
  }
  const auto comparable = std::ranges::count_if(rows, &PublishedRow::comparable);
  const auto judged = std::ranges::count_if(rows, [](const PublishedRow& row) { return z_score(row).has_value(); });
  return text + fmt::format("\n{} rows, {} comparable; {} beside a published uncertainty (z)\n", rows.size(),
                            comparable, judged);
}

std::string published_csv(const std::vector<PublishedRow>& rows) {
  std::string text =
      "name,quantity,of,ours,relation,published,uncertainty,z,unit,comparable,reason,conditions,source\n";
  for (const PublishedRow& row : rows)
    text += fmt::format("{},{},{},{:.9g},{},{:.9g},{},{},{},{},{},{},{}\n", quoted(row.name), row.quantity,
                        quoted(row.of), row.ours, row.relation, row.published, number_or_nothing(row.uncertainty),
                        number_or_nothing(z_score(row)), quoted(row.unit), row.comparable, quoted(row.reason),
                        quoted(row.conditions), quoted(row.source));
  return text;
}

Result published_result(std::vector<PublishedRow> rows) {
  Result result;
  result.command = Command::published;
  result.beside = std::move(rows);
  return result;
}

}  // namespace validate
