// Where atoms broke, in words.
#pragma once

#include <string>
#include <vector>

#include "compare/results/result.hpp"

namespace validate {

/// A sentence for each curve of atoms that broke: the bracket of force and depth, and where the calibrated sheet tears.
std::vector<std::string> breaking_sentences(const Result& result);

}  // namespace validate
