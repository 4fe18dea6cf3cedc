// The rows of a verification as text, CSV and result.
#pragma once

#include <string>
#include <vector>

#include "compare/documents/texts/text_table.hpp"
#include "compare/results/result.hpp"

namespace validate {

/// One line a row: verdict, case, quantity, computed, reference, relative error, tolerance, origin. Below, how many
/// rows rest on what. Columns are left out where `width` is too small.
std::string verification_text(const std::vector<VerificationRow>& rows, int width = widest_line);

/// Header group,name,quantity,ours,relation,published,source,basis,relative_error,tolerance,pass,note; texts in
/// quotes.
std::string verification_csv(const std::vector<VerificationRow>& rows);

/// The rows in the result tree, with the exit code that they mean.
Result verification_result(std::vector<VerificationRow> rows);

}  // namespace validate
