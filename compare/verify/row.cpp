#include "compare/verify/row.hpp"

#include <cmath>

namespace validate::verify {

double relative_error(const Row& row) {
  const double difference = std::abs(row.computed - row.reference.value);
  return row.reference.value == 0 ? difference : difference / std::abs(row.reference.value);
}

bool passes(const Row& row) {
  const double slack = row.tolerance * (row.reference.value == 0 ? 1 : std::abs(row.reference.value));
  switch (row.relation) {
    case Relation::at_most:
      return row.computed <= row.reference.value + slack;
    case Relation::at_least:
      return row.computed >= row.reference.value - slack;
    case Relation::equal:
      break;
  }
  return relative_error(row) <= row.tolerance;
}

}  // namespace validate::verify
