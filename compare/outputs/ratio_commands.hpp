// Atoms over membrane against the relative depth, as gnuplot commands.
#pragma once

#include <string>

#include "compare/result.hpp"

namespace compare {

/// Force and energy ratio of every comparison against depth / effective radius, the tolerance as a band, the
/// judged window as thin lines; empty where nothing is compared.
std::string ratio_commands(const Result& result);

}  // namespace compare
