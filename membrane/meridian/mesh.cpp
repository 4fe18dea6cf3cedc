#include "membrane/meridian/mesh.hpp"

#include <algorithm>
#include <cmath>

#include "membrane/meridian/round_problem.hpp"

namespace membrane::meridian {
namespace {

constexpr double growth = 0.3;
constexpr double largest_share = 1.0 / 40;  // of the radius
constexpr double under_load = 1.0 / 10;     // of the load's radius
constexpr double under_sphere = 1.0 / 60;   // of the sphere's radius: contact ends somewhere inside
constexpr double first_contact = 1.0 / 8;   // of that, at the tip, where contact begins if nothing spreads it
constexpr double layer_share = 3;           // of √(κ/E·h), the length of the thinnest boundary layer there can be
constexpr double point_membrane = 1e-10;    // of the radius: w ~ r^(2/3), no length of its own
constexpr double point_plate = 1e-4;        // of the radius: w ~ r² ln r

/// The foci of a load, and the radius where its density jumps.
struct Demand {
  double radius;
  double layer;  // 0: membrane
  std::vector<Focus> foci{};
  std::vector<double> fixed{};

  double in_layer(double size) const { return layer > 0 ? std::min(layer, size) : size; }

  void patch(double load_radius) {
    foci.push_back({0, 0, under_load * load_radius});
    foci.push_back({load_radius, load_radius, in_layer(under_load * load_radius)});
    if (load_radius < radius) fixed.push_back(load_radius);
  }

  void operator()(const CentreForce&) { foci.push_back({0, 0, radius * (layer > 0 ? point_plate : point_membrane)}); }
  void operator()(const SpreadForce& spread) { patch(spread.radius_A); }
  void operator()(const RigidSphere& sphere) {
    const double size = under_sphere * sphere.radius_A;
    foci.push_back({0, std::min(sphere.radius_A, radius), size});
    if (layer == 0) foci.push_back({0, 0, first_contact * size});
  }
  void operator()(const FollowerPressure&) {}
  void operator()(const EdgeMotion&) {}  // no load of a meridian: check()
};

}  // namespace

std::vector<double> graded_radii(double sheet_radius, const std::vector<double>& fixed, const std::vector<Focus>& foci,
                                 double growth_rate, double largest) {
  const auto size = [&](double r) {
    double smallest = largest;
    for (const Focus& focus : foci) {
      const double away = std::max({focus.from_A - r, r - focus.to_A, 0.0});
      smallest = std::min(smallest, focus.size_A + growth_rate * away);
    }
    return smallest;
  };
  std::vector<double> stations = fixed;
  stations.push_back(sheet_radius);
  std::vector<double> radii{0};
  for (double end : stations) {
    while (radii.back() < end) {
      const double r = radii.back();
      const double length = std::min(size(r), size(std::min(r + size(r), end)));
      radii.push_back(r + 1.5 * length < end ? r + length : end);  // no sliver before a station
    }
  }
  return radii;
}

std::vector<double> nodes_for(const Problem& problem) {
  const double radius = radius_A(problem), refinement = std::get<Meridian>(problem.discretisation).refinement;
  const double layer = layer_share * std::sqrt(bending_modulus_eV(problem) / sheet_modulus(problem.law));
  Demand demand{radius, layer};
  std::visit(demand, action_of(problem.load));
  const double largest = largest_share * radius;
  demand.foci.push_back({radius, radius, demand.in_layer(largest)});
  for (Focus& focus : demand.foci) focus.size_A /= refinement;
  return graded_radii(radius, demand.fixed, demand.foci, growth / refinement, largest / refinement);
}

}  // namespace membrane::meridian
