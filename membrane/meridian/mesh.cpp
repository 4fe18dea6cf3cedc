#include "membrane/meridian/mesh.hpp"

#include <algorithm>
#include <cmath>

#include "membrane/meridian/round_problem.hpp"
#include "membrane/meridian/tuning.hpp"

namespace membrane::meridian {
namespace {

/// The foci of a load, and the radius where its density jumps.
struct Demand {
  double radius;
  double layer;  // 0: membrane
  std::vector<Focus> foci{};
  std::vector<double> fixed{};

  double in_layer(double size) const { return layer > 0 ? std::min(layer, size) : size; }

  void patch(double load_radius) {
    foci.push_back({0, 0, MeshTuning::under_load * load_radius});
    foci.push_back({load_radius, load_radius, in_layer(MeshTuning::under_load * load_radius)});
    if (load_radius < radius) fixed.push_back(load_radius);
  }

  void operator()(const CentreForce&) {
    foci.push_back({0, 0, radius * (layer > 0 ? MeshTuning::point_plate : MeshTuning::point_membrane)});
  }
  void operator()(const SpreadForce& spread) { patch(spread.radius_A); }
  void operator()(const RigidSphere& sphere) {
    const double size = MeshTuning::under_sphere * sphere.radius_A;
    foci.push_back({0, std::min(sphere.radius_A, radius), size});
    if (layer == 0) foci.push_back({0, 0, MeshTuning::first_contact * size});
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
  const double layer = MeshTuning::layer_share * std::sqrt(bending_modulus_eV(problem) / sheet_modulus(problem.law));
  Demand demand{radius, layer};
  std::visit(demand, action_of(problem.load));
  const double largest = MeshTuning::largest_share * radius;
  demand.foci.push_back({radius, radius, demand.in_layer(largest)});
  for (Focus& focus : demand.foci) focus.size_A /= refinement;
  return graded_radii(radius, demand.fixed, demand.foci, MeshTuning::growth / refinement, largest / refinement);
}

}  // namespace membrane::meridian
