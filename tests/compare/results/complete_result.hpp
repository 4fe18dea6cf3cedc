// Results with something in every member, whatever the members are: what a document leaves out or confuses shows.
#pragma once

#include "compare/results/result.hpp"
#include "compare/results/sheet_columns.hpp"

namespace sample {

/// Every described member of the command's documents holds a value of its own, within its range; lists hold three,
/// enumerators go through all their values, pictures of solved sheets included.
validate::Result complete(validate::Command command);

/// A picture of two triangles.
validate::SheetPicture picture();

}  // namespace sample
