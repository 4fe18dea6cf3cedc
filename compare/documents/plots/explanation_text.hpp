// What the plain membrane lacks, as the terminal shows it and as a stacked bar.
#pragma once

#include <string>
#include <vector>

#include "compare/results/result.hpp"

namespace validate {

/// A share of the explanation: its name in tables, figures and columns, in the order they are added.
struct Share {
  const char* name;
  std::vector<double> Explanation::*values;
  const char* colour;
};
const std::vector<Share>& shares();

/// At most eight of the depths, evenly spread, the first and the last among them.
std::vector<std::size_t> shown_depths(std::size_t count);

/// One block per load: shares in per cent of the plain membrane's force, and the atoms over each continuum. Empty
/// without calibrated curves.
std::string explanation_text(const Result& result);

/// gnuplot commands for one panel of stacked bars per load; empty where there is nothing to explain.
std::string explanation_commands(const Result& result);

}  // namespace validate
