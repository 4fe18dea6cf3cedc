// A case file (TOML) into a Case.
#pragma once

#include <filesystem>
#include <string_view>

#include "compare/input/case.hpp"

namespace validate {

/// Overwrites the fields that the file gives and returns where they stand. A potential given as a relative
/// path is taken from the case file's folder, so that a case works from any current directory. `label` (a
/// flag) starts the message about a file that cannot be read. Throws Error: bad input with file, line, key,
/// value and what is allowed; file failed if it cannot be read.
Origins read_case(const std::filesystem::path& file, Case&, std::string_view label = {});

}  // namespace validate
