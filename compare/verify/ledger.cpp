#include "compare/verify/ledger.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace validate::verify {

void Ledger::add(std::string quantity, double computed, Relation relation, Reference reference, double tolerance,
                 std::string note) {
  const double size = reference.value == 0 ? 1 : std::abs(reference.value), over = computed - reference.value;
  const double error = std::abs(over) / size, slack = tolerance * size;
  const bool pass = relation == Relation::equal     ? error <= tolerance
                    : relation == Relation::at_most ? over <= slack
                                                    : over >= -slack;
  rows_.push_back({group_, name_, std::move(quantity), computed, relation, reference.value, std::move(reference.origin),
                   reference.basis, error, tolerance, pass, std::move(note)});
  on_row_(rows_.back());
}

void Ledger::equal(std::string quantity, double computed, Reference reference, double tolerance, std::string note) {
  add(std::move(quantity), computed, Relation::equal, std::move(reference), tolerance, std::move(note));
}

void Ledger::at_most(std::string quantity, double computed, Reference bound, std::string note) {
  add(std::move(quantity), computed, Relation::at_most, std::move(bound), 0, std::move(note));
}

void Ledger::at_least(std::string quantity, double computed, Reference bound, std::string note) {
  add(std::move(quantity), computed, Relation::at_least, std::move(bound), 0, std::move(note));
}

void Ledger::converging(const std::string& quantity, const MeshPair& values, const Reference& reference, double order,
                        double most) {
  constexpr double safety = 1.5;
  constexpr double order_tolerance = 0.3;
  const double foretold =
      std::abs(values.fine - values.coarse) / (std::pow(values.refinement, order) - 1) / std::abs(reference.value);
  equal(quantity, values.fine, reference, std::min(safety * foretold, most),
        fmt::format("{}; error foretold from both {:.1e}", values.meshes, foretold));
  const double coarse_error = std::abs(values.coarse - reference.value);
  const double fine_error = std::abs(values.fine - reference.value);
  equal(quantity + ", observed order", std::log(coarse_error / fine_error) / std::log(values.refinement),
        identity(order, "order of the mesh's error"), order_tolerance / order, values.meshes);
}

}  // namespace validate::verify
