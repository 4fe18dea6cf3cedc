// What a temperature does, in words.
#pragma once

#include <string>
#include <vector>

#include "compare/results/result.hpp"

namespace validate {

/// One paragraph per curve that was heated, and where it was not stable.
std::vector<std::string> thermal_sentences(const Result& result);

/// Depth by depth: shift and force ratio, by dynamics too where it was sampled. Empty where nothing was heated.
std::string thermal_table(const Result& result);

/// Of the flat sheet, a line per statistics.
std::string warm_lines(const std::vector<WarmSheet>& warm, double a0_A, double Eh_eV_per_A2);

}  // namespace validate
