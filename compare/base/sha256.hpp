// Fingerprint of a file's content, recorded with every result.
#pragma once

#include <string>
#include <string_view>

namespace validate {

/// SHA-256 as 64 lower-case hexadecimal digits.
std::string sha256(std::string_view content);

}  // namespace validate
