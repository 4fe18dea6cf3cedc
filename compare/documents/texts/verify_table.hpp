// The rows of a verification as text, CSV and result.
#pragma once

#include <string>
#include <vector>

#include "compare/results/result.hpp"
#include "compare/verify/row.hpp"

namespace validate::verify {

/// One line a row: verdict, case, quantity, computed, reference, relative error, tolerance, origin.
std::string table_text(const std::vector<Row>& rows);

/// Header group,case,quantity,computed,relation,reference,origin,relative_error,tolerance,pass,note; texts in
/// quotes.
std::string table_csv(const std::vector<Row>& rows);

/// The rows in the result tree, with the exit code that they mean.
Result verification_result(const std::vector<Row>& rows);

}  // namespace validate::verify
