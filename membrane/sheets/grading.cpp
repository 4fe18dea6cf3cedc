#include "membrane/sheets/grading.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace membrane {
namespace {

constexpr double width_exponent = 7.0 / 9;
constexpr double growth = 1 - width_exponent;
/// Widths just outside the load's edge over those inside. A ring's number is also its number of segments, so
/// rings spent under the load refine the angle everywhere outside: with 2 the force under a disc of a/11 errs
/// least (0.12 % with 44 rings; 0.15 % with 1, 0.12 % with 3, falling as the square of the rings).
constexpr double edge_widening = 2;
constexpr int fewest_rings_under_load = 6;
/// Of a sheet that bends: ring widths at the load over √(κ/E·h) (0.23 Å for graphene).
constexpr double edge_layers = 6, point_layers = 1;
constexpr double widening = 0.15;     // of the width, per distance from there
constexpr double widest_share = 1.2;  // of the mean width

/// Ring coordinate s(r) = ∫ dr/h, up to a factor, and its inverse.
class Grading {
 public:
  virtual ~Grading() = default;
  virtual double coordinate(double r) const = 0;
  virtual double radius(double s) const = 0;
};

/// Of a membrane. Under the load the coordinate rises to edge_widening.
class TipGrading final : public Grading {
 public:
  explicit TipGrading(double load_radius) : c_(load_radius) {}

  double coordinate(double r) const override {
    if (c_ == 0) return std::pow(r, growth);
    return r <= c_ ? edge_widening * r / c_ : edge_widening + (std::pow(r / c_, growth) - 1) / growth;
  }
  double radius(double s) const override {
    if (c_ == 0) return std::pow(s, 1 / growth);
    return s <= edge_widening ? c_ * s / edge_widening : c_ * std::pow(1 + growth * (s - edge_widening), 1 / growth);
  }

 private:
  double c_;
};

/// Of a sheet that bends: h rises linearly with the distance from the load, up to a largest width.
class LayerGrading final : public Grading {
 public:
  explicit LayerGrading(const RingDemand& demand) : step_(demand.sheet_radius_A / intervals), at_{0} {
    for (int i = 0; i < intervals; ++i) at_.push_back(at_.back() + step_ / width(demand, (i + 0.5) * step_));
  }

  double coordinate(double r) const override {
    const int i = std::clamp(static_cast<int>(r / step_), 0, intervals - 1);
    return at_[i] + (at_[i + 1] - at_[i]) * (r / step_ - i);
  }
  double radius(double s) const override {
    const auto above = std::upper_bound(at_.begin() + 1, at_.end() - 1, s);
    const double low = *(above - 1);
    return step_ * (static_cast<double>(above - 1 - at_.begin()) + (s - low) / (*above - low));
  }

 private:
  static constexpr int intervals = 4000;

  static double width(const RingDemand& demand, double r) {
    const auto near = [&](double layers, double away) {
      return layers * demand.layer_A + widening * std::max(away, 0.0);
    };
    double width = widest_share * demand.sheet_radius_A / demand.rings;
    if (demand.load_radius_A > 0) width = std::min(width, near(edge_layers, r - demand.load_radius_A));
    if (demand.at_point) width = std::min(width, near(point_layers, r));
    return width;
  }

  double step_;
  std::vector<double> at_;  ///< coordinate at every step
};

std::unique_ptr<Grading> grading_for(const RingDemand& demand) {
  if (demand.layer_A > 0) return std::make_unique<LayerGrading>(demand);
  return std::make_unique<TipGrading>(demand.load_radius_A);
}

struct Anchor {
  double radius;
  int ring;
};

/// Ring of the load's edge: its share of the coordinate, but enough rings on both sides.
Anchor load_anchor(const Grading& grading, const RingDemand& demand) {
  const double share = grading.coordinate(demand.load_radius_A) / grading.coordinate(demand.sheet_radius_A);
  const int inside = static_cast<int>(std::lround(share * demand.rings));
  return {demand.load_radius_A,
          std::clamp(inside, std::min(fewest_rings_under_load, demand.rings / 2), demand.rings - 1)};
}

/// Puts a ring on the record radius, into the interval of anchors that holds it; left out within a quarter of
/// a ring's width of an anchor, where it would make slivers.
void add_record_anchor(const Grading& grading, double radius, std::vector<Anchor>& anchors) {
  const auto above = std::find_if(anchors.begin(), anchors.end(), [&](const Anchor& a) { return a.radius > radius; });
  if (above == anchors.begin() || above == anchors.end()) return;
  const Anchor below = *(above - 1);
  const double low = grading.coordinate(below.radius);
  const double share = (grading.coordinate(radius) - low) / (grading.coordinate(above->radius) - low);
  const int rings = above->ring - below.ring;
  if (rings < 2 || share * rings < 0.25 || (1 - share) * rings < 0.25) return;
  const int ring = below.ring + std::clamp(static_cast<int>(std::lround(share * rings)), 1, rings - 1);
  anchors.insert(above, {radius, ring});
}

}  // namespace

std::vector<double> graded_radii(const RingDemand& demand) {
  const std::unique_ptr<Grading> chosen = grading_for(demand);
  const Grading& grading = *chosen;
  std::vector<Anchor> anchors{{0, 0}};
  if (demand.load_radius_A > 0) anchors.push_back(load_anchor(grading, demand));
  anchors.push_back({demand.sheet_radius_A, demand.rings});
  if (demand.record_radius_A > 0) add_record_anchor(grading, demand.record_radius_A, anchors);

  std::vector<double> radii(demand.rings + 1);
  for (std::size_t i = 1; i < anchors.size(); ++i) {
    const auto& [low_radius, low] = anchors[i - 1];
    const auto& [high_radius, high] = anchors[i];
    const double from = grading.coordinate(low_radius);
    const double to = grading.coordinate(high_radius);
    for (int ring = low + 1; ring < high; ++ring)
      radii[ring] = grading.radius(from + (to - from) * (ring - low) / (high - low));
    radii[high] = high_radius;  // exactly, not to rounding
  }
  return radii;
}

std::vector<double> uniform_radii(const RingDemand& demand) {
  const double width = demand.sheet_radius_A / demand.rings;
  std::vector<double> radii(demand.rings + 1);
  for (int ring = 0; ring <= demand.rings; ++ring) radii[ring] = width * ring;
  radii.back() = demand.sheet_radius_A;
  for (double wanted : {demand.record_radius_A, demand.load_radius_A}) {  // the load's edge has the last word
    const int nearest = std::clamp(static_cast<int>(std::lround(wanted / width)), 1, demand.rings - 1);
    if (wanted > 0) radii[nearest] = wanted;
  }
  return radii;
}

}  // namespace membrane
