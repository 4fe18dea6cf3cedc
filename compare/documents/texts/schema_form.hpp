// A finished JSON schema in its shortest form.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace validate {

/// Moves each object's schema that occurs more than once to "definitions", under the key of the property that it was
/// found at first, and refers to it. Descriptions stay where they are.
void share_repeated_objects(nlohmann::ordered_json& schema);

}  // namespace validate
