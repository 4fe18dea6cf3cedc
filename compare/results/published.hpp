// Published numbers beside ours.
#pragma once

#include <optional>
#include <string>

#include "compare/base/describe.hpp"
#include "compare/results/checks.hpp"

namespace validate {

/// One line of `validate published`. Ours, the published number and its uncertainty are in `unit`.
struct PublishedRow {
  std::string name, quantity;
  std::string of;  ///< whose quantity ours is: a potential, or the membrane
  double ours = not_known;
  Relation relation = Relation::equal;
  double published = not_known;
  std::optional<double> uncertainty;  ///< as published; none: none was
  std::string unit, conditions;
  bool comparable = false;
  std::string reason;  ///< why it is not
  std::string source;  ///< with DOI or arXiv number
};

/// (ours − published) / uncertainty, where one is published.
std::optional<double> z_score(const PublishedRow& row);

/// ours / published − 1; none for a bound or beside 0.
std::optional<double> difference(const PublishedRow& row);

/// Whether a bound holds; none where the published number is no bound.
std::optional<bool> holds(const PublishedRow& row);

/// What follows from the members is written, not read.
void describe(SameStruct<PublishedRow> auto& row, auto&& visit) {
  std::optional<double> z = z_score(row), relative = difference(row);
  std::optional<bool> bound_holds = holds(row);
  visit(Field{"name", unit::none, "of the published number"}, row.name);
  visit(Field{"quantity", unit::none, "which of ours stands beside it"}, row.quantity);
  visit(Field{"of", unit::none, "whose quantity ours is: a potential, or the membrane"}, row.of);
  visit(Field{"ours", unit::none, "computed now, in `unit`"}, row.ours);
  visit(Field{"relation", unit::none, "= a number, <= and >= a bound"}, row.relation);
  visit(Field{"published", unit::none, "in `unit`"}, row.published);
  visit(Field{"uncertainty", unit::none, "as published, in `unit`; null: none was published"}, row.uncertainty);
  visit(Field{"z", unit::none, "(ours - published) / uncertainty; null: no uncertainty"}, z);
  visit(Field{"difference_relative", unit::none, "ours / published - 1; null beside a bound or 0"}, relative);
  visit(Field{"holds", unit::none, "whether the bound holds; null where it is none"}, bound_holds);
  visit(Field{"unit", unit::none, "of the three numbers"}, row.unit);
  visit(Field{"conditions", unit::none, "under which the published number was found"}, row.conditions);
  visit(Field{"comparable", unit::none, "both mean the same; false: see the reason"}, row.comparable);
  visit(Field{"reason", unit::none, "why they do not"}, row.reason);
  visit(Field{"source", unit::none, "publication, with DOI or arXiv number"}, row.source);
}

}  // namespace validate
