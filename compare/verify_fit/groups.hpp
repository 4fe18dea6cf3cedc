// What `validate verify fit` verifies, group by group.
#pragma once

#include <vector>

#include "compare/verify/groups.hpp"

namespace validate::verify {

/// Eighty curves a case, or three thousand: of a share of 95 % chance then makes 0.4 %.
std::vector<Group> fit_groups(bool full);

}  // namespace validate::verify
