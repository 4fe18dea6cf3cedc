#include "atomistic/lattice/ripple.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace atomistic {
namespace {

constexpr int waves = 16;
constexpr double shortest_A = 10, longest_A = 60, edge_A = 8;

struct Wave {
  Eigen::Vector2d q;
  double phase;
};

std::vector<Wave> random_waves(unsigned seed) {
  std::mt19937 random(seed);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };  // the same on every system
  std::vector<Wave> all;
  for (int k = 0; k < waves; ++k) {
    const double direction = 2 * std::numbers::pi * uniform(), phase = 2 * std::numbers::pi * uniform();
    const double length = shortest_A * std::pow(longest_A / shortest_A, uniform());
    all.push_back({2 * std::numbers::pi / length * Eigen::Vector2d(std::cos(direction), std::sin(direction)), phase});
  }
  return all;
}

/// 0 at the edge of the free sheet, 1 from edge_A inwards.
double window(const Sheet& sheet, const Eigen::Vector2d& place) {
  const double out = sheet.form.shape == Shape::disc ? place.norm() : place.cwiseAbs().maxCoeff();
  return std::clamp((sheet.radius_A - out) / edge_A, 0.0, 1.0);
}

}  // namespace

Eigen::VectorXd ripple_around(const Sheet& sheet, double amplitude_A, int waves_around) {
  // What wrinkles do: nothing at the rim, most at four fifths of the radius, next to nothing in the middle.
  const auto height = [](double s) { return s < 1 ? std::pow(s, 4) * (1 - s) / (std::pow(0.8, 4) * 0.2) : 0; };
  Eigen::VectorXd u = Eigen::VectorXd::Zero(3 * sheet.free_atoms);
  for (int i = 0; i < sheet.free_atoms; ++i) {
    const Eigen::Vector2d place = sheet.position(i).head<2>();
    const double angle = std::atan2(place.y(), place.x());
    u[3 * i + 2] = amplitude_A * height(place.norm() / sheet.radius_A) * std::cos(waves_around * angle);
  }
  return u;
}

Eigen::VectorXd ripple(const Sheet& sheet, double rms_A, unsigned seed) {
  const std::vector<Wave> all = random_waves(seed);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(3 * sheet.free_atoms);
  for (int i = 0; i < sheet.free_atoms; ++i) {
    const Eigen::Vector2d place = sheet.position(i).head<2>();
    for (const Wave& wave : all) u[3 * i + 2] += window(sheet, place) * std::sin(wave.q.dot(place) + wave.phase);
  }
  return u * (rms_A * std::sqrt(static_cast<double>(sheet.free_atoms)) / u.norm());
}

}  // namespace atomistic
