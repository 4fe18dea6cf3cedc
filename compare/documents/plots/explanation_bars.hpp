// What the plain membrane lacks, as stacked bars.
#pragma once

#include <string>
#include <vector>

#include "compare/documents/plots/plot.hpp"
#include "compare/results/result.hpp"

namespace validate {

/// A share of the explanation: its name in tables, figures and columns, in the order they are added.
struct Share {
  const char* name;
  std::vector<double> Explanation::*values;
  Colour colour;
};
const std::vector<Share>& shares();

/// The sum of the shares at each depth: atoms over the plain membrane, − 1.
std::vector<double> sum_of_shares(const Explanation& explanation);

/// At most eight of the depths, evenly spread, the first and the last among them.
std::vector<std::size_t> shown_depths(std::size_t count, std::size_t most = 8);

/// One panel a load: shares in per cent of the plain membrane's force at the shown depths, and the atoms as squares. No
/// panel where there is nothing to explain.
Plot explanation_plot(const Result& result);

}  // namespace validate
