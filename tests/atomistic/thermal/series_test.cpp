#include "atomistic/thermal/series.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using namespace atomistic;

/// x' = φ x + noise, of variance 1 and integrated autocorrelation ½ (1 + φ)/(1 − φ), about `mean`.
std::vector<double> autoregressive(double phi, double mean, std::size_t count, unsigned seed, double start = 0) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> x;
  double at = start;
  for (std::size_t i = 0; i < count; ++i) {
    at = phi * at + std::sqrt(1 - phi * phi) * normal(random);
    x.push_back(mean + at);
  }
  return x;
}

TEST(Series, TheErrorCountsTheCorrelation) {
  constexpr double phi = 0.9;
  constexpr int repeats = 300;
  double squares = 0, claimed = 0, length = 0;
  for (int k = 0; k < repeats; ++k) {
    const SeriesMean mean = mean_of(autoregressive(phi, 3, 4000, static_cast<unsigned>(k + 1)));
    squares += std::pow(mean.mean - 3, 2) / repeats;
    claimed += mean.error * mean.error / repeats;
    length += mean.correlation_length / repeats;
  }
  EXPECT_NEAR(length, 0.5 * (1 + phi) / (1 - phi), 1);
  EXPECT_NEAR(std::sqrt(claimed / squares), 1, 0.12);
}

TEST(Series, TheWarmUpIsLeftOut) {
  const SeriesMean mean = mean_of(autoregressive(0.95, 0, 4000, 5, 30));
  EXPECT_GT(mean.warm_up, 30u);
  EXPECT_LT(mean.warm_up, 600u);
  EXPECT_LT(std::abs(mean.mean), 5 * mean.error);
}

TEST(Series, IndependentValuesAreWorthThemselves) {
  const SeriesMean mean = mean_of(autoregressive(0, 1, 5000, 7));
  EXPECT_NEAR(mean.samples, 5000 - static_cast<double>(mean.warm_up), 700);
  EXPECT_NEAR(mean.deviation, 1, 0.05);
}

TEST(Series, OfAFewValuesKnowsNothing) { EXPECT_TRUE(std::isinf(mean_of({1, 2, 3}).error)); }

}  // namespace
