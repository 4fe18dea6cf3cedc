// The rows as text, CSV and JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compare/verify/row.hpp"

namespace validate::verify {

/// One line a row: verdict, case, quantity, computed, reference, relative error, tolerance, origin.
std::string table_text(const std::vector<Row>& rows);

/// Header group,case,quantity,computed,relation,reference,origin,relative_error,tolerance,pass,note; texts in
/// quotes.
std::string table_csv(const std::vector<Row>& rows);

/// {passed, failed, rows: [{group, case, …}]}; numbers that are not finite are null.
nlohmann::json table_json(const std::vector<Row>& rows);

}  // namespace validate::verify
