#include "compare/results/result.hpp"

#include <cmath>

namespace validate {

double artefact_bond_of(const Result& result) {
  constexpr double usual_A = 1.70;
  return result.card && std::isfinite(result.card->artefact_bond_A) ? result.card->artefact_bond_A : usual_A;
}

bool passes(const FigureNumber& n) {
  return n.tolerance <= 0 || std::abs(n.ours - n.reference) <= n.tolerance * std::abs(n.reference);
}

std::optional<double> allowance(const VerificationRow& row) {
  const double size = row.reference == 0 ? 1 : std::abs(row.reference);
  if (row.relation != Relation::equal || !(row.tolerance > 0)) return std::nullopt;
  return row.tolerance * size;
}

std::optional<double> z_score(const VerificationRow& row) {
  const auto allowed = allowance(row);
  if (!allowed) return std::nullopt;
  return (row.computed - row.reference) / *allowed;
}

}  // namespace validate
