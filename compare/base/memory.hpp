// How much memory there is for what is about to start.
#pragma once

#include <optional>

namespace validate {

/// Bytes that new processes can take without swapping: what the system calls available, no more than is left of a
/// control group's limit (version 2) or of the limit that a process inherits. Nothing where the system does not say.
std::optional<double> available_memory_bytes();

}  // namespace validate
