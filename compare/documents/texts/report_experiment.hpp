// What an experiment's page says above its figures and below them.
#pragma once

#include <string>

#include "compare/results/result.hpp"

namespace validate {

/// What was compared, in the units that people are shown; text, not markup.
std::string experiment_title(const Result& result);

/// Heading and verdict.
std::string experiment_verdict(const Result& result);

/// E·h and pretension as true and as read, table of the pressures.
std::string experiment_tables(const Result& result);

/// Regimes and ratios, fits with intervals and warnings, convergence per depth.
std::string experiment_details(const Result& result);

}  // namespace validate
