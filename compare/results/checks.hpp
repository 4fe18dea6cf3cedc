// Numbers beside their references: those of the paper's figures, and the rows of a verification.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "compare/base/describe.hpp"
#include "compare/base/words.hpp"
#include "compare/results/known.hpp"

namespace validate {

/// A published number, or one computed with codes written separately, beside ours.
struct FigureNumber {
  std::string what, unit, source;
  double reference = 0, ours = 0;
  double tolerance = 0;  ///< relative; 0: a difference that is the point of the figure
  std::string comment;   ///< where they differ, why
};

void describe(SameStruct<FigureNumber> auto& number, auto&& visit) {
  visit(Field{"what", unit::none, "quantity and case"}, number.what);
  visit(Field{"unit", unit::none, "of both numbers"}, number.unit);
  visit(Field{"ours", unit::none, "computed here"}, number.ours);
  visit(Field{"reference", unit::none, "published, or computed with a code written separately"}, number.reference);
  visit(Field{"tolerance", unit::none, "relative; 0: none is asked"}, number.tolerance);
  visit(Field{"source", unit::none, "of the reference"}, number.source);
  visit(Field{"comment", unit::none, "where they differ, why"}, number.comment);
}

/// Whether ours is within the tolerance; true where none is asked.
bool passes(const FigureNumber& number);

/// One of the paper's figures, made anew.
struct FigureResult {
  int number = 0;
  std::string title;
  std::vector<FigureNumber> numbers;
  std::vector<std::string> remarks;  ///< what the numbers alone do not say
};

void describe(SameStruct<FigureResult> auto& figure, auto&& visit) {
  visit(Field{"number", unit::none, "of the figure in the paper"}, figure.number);
  visit(Field{"title", unit::none, "what it shows"}, figure.title);
  visit(Field{"numbers", unit::none, "ours beside the reference"}, figure.numbers);
  visit(Field{"remarks", unit::none, "what the numbers alone do not say"}, figure.remarks);
}

/// What a computed value owes to its reference.
enum class Relation { equal, at_most, at_least };
constexpr auto words(Relation) {
  return std::array{Word{Relation::equal, "="}, Word{Relation::at_most, "<="}, Word{Relation::at_least, ">="}};
}

/// What a reference rests on.
enum class Basis {
  outside,  ///< a closed form, a publication, or code that shares nothing with what is verified
  itself    ///< what the code owes to itself: balance, order of an error, invariance, another way through the same code
};
constexpr auto words(Basis) { return std::array{Word{Basis::outside, "outside"}, Word{Basis::itself, "itself"}}; }

/// One line of `validate verify`.
struct VerificationRow {
  std::string group, name, quantity;  ///< the name is that of the case
  double computed = not_known;
  Relation relation = Relation::equal;
  double reference = not_known;
  std::string origin;  ///< of the reference: a formula, a publication or an independent solver
  Basis basis = Basis::outside;
  double relative_error = not_known;  ///< absolute where the reference is 0
  double tolerance = not_known;
  bool pass = false;
  std::string note;  ///< mesh, order of convergence, what the tolerance comes from
};

/// Largest difference that passes, in the quantity's own unit; none of a bound or where nothing is allowed.
std::optional<double> allowance(const VerificationRow& row);

/// Difference over allowance: from −1 to 1 in a row that passes.
std::optional<double> z_score(const VerificationRow& row);

/// What follows from the members is written, not read.
void describe(SameStruct<VerificationRow> auto& row, auto&& visit) {
  std::optional<double> uncertainty = allowance(row), z = z_score(row);
  bool comparable = true;
  visit(Field{"group", unit::none, "group of the row"}, row.group);
  visit(Field{"name", unit::none, "the case: what is computed"}, row.name);
  visit(Field{"quantity", unit::none, "of it"}, row.quantity);
  visit(Field{"ours", unit::none, "computed"}, row.computed);
  visit(Field{"relation", unit::none, "what ours owes to the reference: =, <= or >="}, row.relation);
  visit(Field{"published", unit::none, "the reference"}, row.reference);
  visit(Field{"uncertainty", unit::none, "largest difference that passes; null: a bound, or exact"}, uncertainty);
  visit(Field{"z", unit::none, "difference over uncertainty"}, z);
  visit(Field{"comparable", unit::none, "always here: the reference is of the same quantity"}, comparable);
  visit(Field{"source", unit::none, "where the reference comes from"}, row.origin);
  visit(Field{"basis", unit::none,
              "outside: a closed form, a publication, other code; itself: what the code owes to itself"},
        row.basis);
  visit(Field{"relative_error", unit::none, "absolute where the reference is 0"}, row.relative_error);
  visit(Field{"tolerance", unit::none, "largest error that passes"}, row.tolerance);
  visit(Field{"pass", unit::none, "within it"}, row.pass);
  visit(Field{"note", unit::none, "mesh, order of convergence, what the tolerance comes from"}, row.note);
}

}  // namespace validate
