// The sheet seen from above: the atoms' longest bonds and the membrane's stress, side by side.
#pragma once

#include <filesystem>
#include <string>

#include "compare/results/result.hpp"

namespace validate {

/// gnuplot commands for two maps at the deepest usable depth of the judged load: the atoms of
/// `folder`/atoms-<load>.extxyz coloured by their longest bond, and the like-for-like (or given) membrane's
/// larger principal Cauchy force, N/m. A map that cannot be made is left out; empty where none can.
std::string field_commands(const Result& result, const std::filesystem::path& folder);

}  // namespace validate
