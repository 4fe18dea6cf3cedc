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

}  // namespace validate
