// run.h5 back into a result, so that documents can be made again without computing.
#pragma once

#include <filesystem>
#include <string_view>

#include "compare/results/result.hpp"

namespace validate {

/// Throws Error: bad input where the file is not a run of this program (`label` starts the message), file
/// failed where it cannot be read. What a file of an older version does not hold keeps its default.
Result read_run_h5(const std::filesystem::path& file, std::string_view label = {});

}  // namespace validate
