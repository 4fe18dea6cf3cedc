// Whole numbers of frames that follow one another, as short as a page can unpack without a library.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace validate {

/// Each frame as its difference from the way the two before it went on (2 f₋₁ − f₋₂; before the first there is 0), in
/// Rice's code with a width of its own for every 32 numbers, in base64. Frames are equally long; numbers are within
/// ± 2²⁸. script/unpack.js reads it.
std::string packed(const std::vector<std::vector<std::int32_t>>& frames);

}  // namespace validate
