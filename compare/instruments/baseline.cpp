#include "compare/instruments/baseline.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace validate {
namespace {

constexpr std::size_t fewest = 10;  ///< points that a line is told from

/// 1.4826 times the median of |miss|: σ of a normal one.
double spread_of(std::vector<double> misses) {
  if (misses.empty()) return 0;
  for (double& miss : misses) miss = std::abs(miss);
  const auto middle = misses.begin() + static_cast<std::ptrdiff_t>(misses.size() / 2);
  std::ranges::nth_element(misses, middle);
  return 1.4826 * *middle;
}

StraightLine through(const std::vector<double>& x, const std::vector<double>& y, const std::vector<std::size_t>& which,
                     bool tilted) {
  StraightLine line;
  line.points = static_cast<int>(which.size());
  for (const std::size_t i : which) {
    line.origin += x[i] / line.points;
    line.level += y[i] / line.points;
  }
  double xx = 0, xy = 0;
  for (const std::size_t i : which) {
    xx += std::pow(x[i] - line.origin, 2);
    xy += (x[i] - line.origin) * (y[i] - line.level);
  }
  if (tilted && xx > 0) line.tilt = xy / xx;
  return line;
}

/// σ of the points from their second differences, which a smooth curve hardly has.
double roughness(const std::vector<double>& y) {
  std::vector<double> differences;
  for (std::size_t i = 1; i + 1 < y.size(); ++i) differences.push_back(y[i + 1] - 2 * y[i] + y[i - 1]);
  const auto [low, high] = std::ranges::minmax(y);
  return std::max(spread_of(std::move(differences)) / std::sqrt(6.0), 1e-9 * (high - low));
}

/// Grows the stretch by a quarter as long as its new points lie on the line, as well as it is known there.
StraightLine followed(const std::vector<double>& x, const std::vector<double>& y, bool tilted) {
  const double noise = roughness(y);
  std::size_t end = std::max(fewest, x.size() / 8);
  StraightLine line = robust_line(x, y, 0, std::min(end, x.size()), tilted);
  while (end < x.size()) {
    const std::size_t next = std::min(x.size(), end + std::max<std::size_t>(end / 4, 2));
    const double stretch = x[end - 1] - x[0];
    std::size_t off = 0;
    for (std::size_t i = end; i < next; ++i) {
      const double lever = tilted && stretch > 0 ? std::sqrt(12.0) * (x[i] - line.origin) / stretch : 0;
      if (std::abs(y[i] - line.at(x[i])) > 4 * noise * std::sqrt(1 + (1 + lever * lever) / line.points)) ++off;
    }
    if (3 * off > next - end) break;
    end = next;
    line = robust_line(x, y, 0, end, tilted);
  }
  return line;
}

/// Behind the last point that is not clearly above the line.
std::size_t contact_by(const StraightLine& line, const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t n = x.size();
  const double highest = y[n - 1] - line.at(x[n - 1]);
  const double far = std::max(5 * line.spread, 0.001 * highest);
  std::size_t at = n;
  while (at > 0 && y[at - 1] - line.at(x[at - 1]) > far) --at;
  return std::min(at, n - 1);
}

/// An attraction of at least two points beyond four standard deviations just before the contact.
void find_snap(BeforeContact& b, const std::vector<double>& x, const std::vector<double>& y) {
  const auto below = [&](std::size_t i) { return b.line.at(x[i]) - y[i]; };
  const double clear = 4 * b.line.spread;
  b.snap = b.contact;
  std::size_t deepest = b.contact;
  int clearly = 0;
  for (std::size_t i = b.contact / 2; i < b.contact; ++i) {
    if (below(i) > clear) ++clearly;
    if (deepest == b.contact || below(i) > below(deepest)) deepest = i;
  }
  if (clearly < 2 || deepest == b.contact) return;
  b.attraction = below(deepest);
  b.snap = deepest;
  while (b.snap > 0 && below(b.snap - 1) > b.line.spread) --b.snap;
  // What is still pulled is no contact yet.
  while (b.contact + 1 < x.size() && below(b.contact) > 0) ++b.contact;
}

}  // namespace

StraightLine robust_line(const std::vector<double>& x, const std::vector<double>& y, std::size_t from, std::size_t to,
                         bool tilted) {
  constexpr int passes = 6;
  std::vector<std::size_t> which;
  for (std::size_t i = from; i < to; ++i) which.push_back(i);
  StraightLine line = through(x, y, which, tilted);
  for (int pass = 0; pass < passes; ++pass) {
    std::vector<double> misses;
    for (std::size_t i = from; i < to; ++i) misses.push_back(y[i] - line.at(x[i]));
    line.spread = spread_of(misses);
    std::vector<std::size_t> kept;
    for (std::size_t i = from; i < to; ++i)
      if (std::abs(misses[i - from]) <= 3 * line.spread) kept.push_back(i);
    if (kept.size() < 3 || kept == which) break;
    const double spread = line.spread;
    line = through(x, y, kept, tilted);
    line.spread = spread;
    which = std::move(kept);
  }
  return line;
}

BeforeContact before_contact(const std::vector<double>& x, const std::vector<double>& y, bool tilted) {
  BeforeContact b;
  if (x.size() < 2 * fewest) return b;
  b.line = followed(x, y, tilted);
  for (int pass = 0; pass < 2; ++pass) {
    b.contact = contact_by(b.line, x, y);
    find_snap(b, x, y);
    // The contact begins before it is clear.
    b.undisturbed = b.snap - b.snap / 20;
    if (b.undisturbed < fewest) {
      b.line.points = 0;
      return b;
    }
    b.line = robust_line(x, y, 0, b.undisturbed, tilted);
  }
  b.contact = contact_by(b.line, x, y);
  find_snap(b, x, y);
  return b;
}

}  // namespace validate
