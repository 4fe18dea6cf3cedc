// Published numbers beside ours, as text, CSV and result.
#pragma once

#include <string>
#include <vector>

#include "compare/results/result.hpp"

namespace validate {

/// A block per published number: its source, conditions and why it is not comparable, below it a line for each of ours.
std::string published_text(const std::vector<PublishedRow>& rows);

/// Header name,quantity,of,ours,relation,published,uncertainty,z,unit,comparable,reason,conditions,source; texts in
/// quotes, what is not known empty.
std::string published_csv(const std::vector<PublishedRow>& rows);

/// The rows in the result tree.
Result published_result(std::vector<PublishedRow> rows);

}  // namespace validate
