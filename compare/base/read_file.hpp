// Whole input files as text, with the errors that belong to them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace validate {

/// Content of a regular file. `label` (flag, or file and line) starts the message where it is not empty.
/// Throws Error: bad input if there is no such file or it is a folder, file failed if it cannot be read.
std::string read_file(const std::filesystem::path& file, std::string_view label = {});

}  // namespace validate
