// Collects the rows of one group while its cases run.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "compare/results/checks.hpp"
#include "compare/verify/reference.hpp"

namespace validate::verify {

using OnRow = std::function<void(const VerificationRow&)>;

/// A quantity on a mesh and on a finer one.
struct MeshPair {
  double coarse = 0, fine = 0;
  std::string meshes;     ///< "36 and 72 rings"
  double refinement = 2;  ///< element sizes, coarse over fine
};

class Ledger {
 public:
  Ledger(std::string group, OnRow on_row) : group_(std::move(group)), on_row_(std::move(on_row)) {}

  /// Names what follows; several quantities belong to one case.
  void begin(std::string name) { name_ = std::move(name); }

  void equal(std::string quantity, double computed, Reference reference, double tolerance, std::string note = {});
  void at_most(std::string quantity, double computed, Reference bound, std::string note = {});
  void at_least(std::string quantity, double computed, Reference bound, std::string note = {});

  /// Two rows. The value on the finer mesh, whose tolerance is one and a half times the error that both
  /// values foretell for this order, |fine − coarse| / (refinement^order − 1), and never more than `most`;
  /// and the observed order, log of the ratio of both errors over that of the refinement, which shows that
  /// the foretelling is right.
  void converging(const std::string& quantity, const MeshPair& values, const Reference& reference, double order,
                  double most);

  const std::vector<VerificationRow>& rows() const { return rows_; }

 private:
  /// Not a number never passes.
  void add(std::string quantity, double computed, Relation relation, Reference reference, double tolerance,
           std::string note);

  std::string group_, name_;
  OnRow on_row_;
  std::vector<VerificationRow> rows_;
};

}  // namespace validate::verify
