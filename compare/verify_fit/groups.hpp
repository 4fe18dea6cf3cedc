// What `validate verify fit` verifies, group by group.
#pragma once

#include <vector>

#include "compare/verify/groups.hpp"

namespace validate::verify {

/// Eighty curves a case, or a thousand.
std::vector<Group> fit_groups(bool full);

}  // namespace validate::verify
