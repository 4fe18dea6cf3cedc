#include "compare/documents/texts/explanation_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/documents/plots/explanation_bars.hpp"

namespace validate {
namespace {

std::string line(const std::string& name, const std::vector<double>& values, const std::vector<std::size_t>& shown,
                 double factor, const char* format) {
  std::string text = fmt::format("  {:<34}", name);
  for (const std::size_t i : shown) {
    const double value = i < values.size() ? factor * values[i] : not_known;
    text += std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : fmt::format("{:>9}", "–");
  }
  return text + "\n";
}

/// Columns of depths beside the names.
std::size_t depths_in(int width) {
  constexpr int names = 36, column = 9;
  return static_cast<std::size_t>(std::clamp((width - names) / column, 2, 8));
}

/// The comparison's values at the depths of the explanation.
std::vector<double> at_depths(const std::vector<double>& values, const Comparison& c, const Explanation& e) {
  std::vector<double> picked;
  for (const double depth : e.depth_A) {
    const auto found = std::ranges::find(c.depth_A, depth);
    picked.push_back(found == c.depth_A.end() ? not_known
                                              : values[static_cast<std::size_t>(found - c.depth_A.begin())]);
  }
  return picked;
}

}  // namespace

std::string explanation_text(const Result& result, int width) {
  std::string text;
  for (const Explanation& e : result.explanations) {
    const auto c = std::ranges::find(result.comparisons, e.load, &Comparison::load);
    if (c == result.comparisons.end()) continue;
    const std::vector<std::size_t> shown = shown_depths(e.depth_A.size(), depths_in(width));
    text += fmt::format("{} load: what a plain membrane lacks, in % of its force, and what is left\n", e.load);
    text += line("depth / a", e.depth_relative, shown, 1, "{:9.3f}");
    for (const Share& share : shares()) text += line(share.name, e.*share.values, shown, 100, "{:+9.2f}");
    text += line("atoms over that membrane", sum_of_shares(e), shown, 100, "{:+9.2f}");
    text += line("atoms / membrane, card constants", at_depths(c->force_ratio, *c, e), shown, 1, "{:9.4f}");
    text +=
        line("atoms / membrane, calibrated law", at_depths(c->calibrated_membrane_ratio, *c, e), shown, 1, "{:9.4f}");
    text += line("atoms / sheet, calibrated law", at_depths(c->sheet_ratio, *c, e), shown, 1, "{:9.4f}");
    text += "\n";
  }
  return text;
}

}  // namespace validate
