#include "compare/base/nearest.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

namespace validate {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
bool same_letter(char a, char b) { return lower(a) == lower(b); }

// Optimal string alignment: insertions, deletions, substitutions and swaps of neighbours count one each.
std::size_t typing_errors(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = same_letter(a[i - 1], b[j - 1]) ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + change});
      if (i > 1 && j > 1 && same_letter(a[i - 1], b[j - 2]) && same_letter(a[i - 2], b[j - 1])) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}

bool starts_with(std::string_view text, std::string_view start) {
  return text.size() >= start.size() &&
         std::equal(start.begin(), start.end(), text.begin(), [](char a, char b) { return same_letter(a, b); });
}

// Half of the letters may be wrong: more would suggest names that have nothing to do with the one typed.
bool is_near(std::size_t errors, std::string_view a, std::string_view b) {
  return 2 * errors <= std::max(a.size(), b.size()) || errors == 1;
}

}  // namespace

std::optional<std::string_view> nearest(std::string_view name, std::span<const std::string_view> candidates) {
  constexpr std::size_t longest_sensible_name = 100;
  if (name.empty() || name.size() > longest_sensible_name) return std::nullopt;
  std::optional<std::string_view> best;
  std::size_t fewest = 0;
  for (const std::string_view candidate : candidates) {
    // "tip" for "tip-radius": an abbreviation is as good as one typing error
    const bool abbreviation = name.size() > 1 && starts_with(candidate, name);
    const std::size_t all_errors = typing_errors(name, candidate);
    const std::size_t errors = abbreviation ? std::min<std::size_t>(1, all_errors) : all_errors;
    if (!is_near(errors, name, candidate)) continue;
    if (!best || errors < fewest) {
      best = candidate;
      fewest = errors;
    }
  }
  return best;
}

std::string did_you_mean(std::string_view name, std::span<const std::string_view> candidates) {
  const auto suggestion = nearest(name, candidates);
  return suggestion ? fmt::format("; did you mean '{}'?", *suggestion) : std::string{};
}

}  // namespace validate
