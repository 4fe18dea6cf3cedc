#include "compare/results/published.hpp"

namespace validate {

std::optional<double> z_score(const PublishedRow& row) {
  if (!row.uncertainty) return std::nullopt;
  return (row.ours - row.published) / *row.uncertainty;
}

std::optional<double> difference(const PublishedRow& row) {
  if (row.relation != Relation::equal || row.published == 0) return std::nullopt;
  return row.ours / row.published - 1;
}

std::optional<bool> holds(const PublishedRow& row) {
  switch (row.relation) {
    case Relation::equal:
      return std::nullopt;
    case Relation::at_most:
      return row.ours <= row.published;
    case Relation::at_least:
      return row.ours >= row.published;
  }
  return std::nullopt;
}

}  // namespace validate
