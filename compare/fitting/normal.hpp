// Noise that is drawn.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace validate {

/// Standard normal numbers that are the same on every machine: Box and Muller's, from the generator's own bits.
class Normal {
 public:
  explicit Normal(std::uint32_t seed) : random_(seed) {}

  double operator()() {
    const double radius = std::sqrt(-2 * std::log(uniform())), angle = 2 * std::numbers::pi * uniform();
    return radius * std::cos(angle);
  }

 private:
  double uniform() { return (static_cast<double>(random_()) + 0.5) / 4294967296.0; }
  std::mt19937 random_;
};

}  // namespace validate
