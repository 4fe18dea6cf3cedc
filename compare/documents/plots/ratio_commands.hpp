// Atoms over membrane against the relative depth, as gnuplot commands.
#pragma once

#include <string>

#include "compare/results/result.hpp"

namespace validate {

/// Force and energy ratio of every comparison against depth / effective radius, the tolerance as a band, the
/// judged window as thin lines; empty where nothing is compared.
std::string ratio_commands(const Result& result);

}  // namespace validate
