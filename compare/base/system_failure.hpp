// What the system refuses, as an error of the user's.
#pragma once

#include <filesystem>
#include <string_view>

#include "compare/base/errors.hpp"

namespace validate {

/// "`what`: reason of the errno". Bad input for a name that no file can have, file failed for everything else.
Error system_failure(std::string_view what, int error);

/// The same of what the library throws.
Error system_failure(const std::filesystem::filesystem_error& error);

}  // namespace validate
