// Whole input files as text, with the errors that belong to them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace validate {

/// Content of a regular file, or of a FIFO (a shell's `<(…)`): never waits for a writer to come, reads at most 1 GiB.
/// `label` (flag, or file and line) starts the message where it is not empty. Throws Error: bad input if there is no
/// such file or it is a folder or a device, file failed if it cannot be read.
std::string read_file(const std::filesystem::path& file, std::string_view label = {});

/// Content of a regular file of the program's own; nothing where there is none that can be read.
std::optional<std::string> read_if_there(const std::filesystem::path& file);

}  // namespace validate
