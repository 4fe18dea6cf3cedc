// One line of the table that `validate verify` prints.
#pragma once

#include <string>

namespace validate::verify {

/// What a computed value owes to its reference.
enum class Relation { equal, at_most, at_least };

/// A number with its origin: a closed form (formula in the text), a publication, or an independent solver.
struct Reference {
  double value = 0;
  std::string origin;
};

struct Row {
  std::string group, name, quantity;  ///< the name is that of the case
  double computed = 0;
  Reference reference;
  Relation relation = Relation::equal;
  double tolerance = 0;  ///< relative; absolute where the reference is 0
  std::string note;      ///< mesh, order of convergence, what the tolerance comes from
};

/// |computed − reference| / |reference|; without the division where the reference is 0.
double relative_error(const Row& row);

/// Not a number never passes.
bool passes(const Row& row);

}  // namespace validate::verify
