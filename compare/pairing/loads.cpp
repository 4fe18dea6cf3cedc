#include "compare/pairing/loads.hpp"

#include <stdexcept>

#include "compare/results/known.hpp"

namespace validate {

namespace {

membrane::Load disc_of(double radius_A) { return membrane::DiscLoad{radius_A}; }

/// One answer for each way in which a load can act: a new one does not compile without.
struct TipRadius {
  double operator()(const membrane::CentreForce&) const { return 0; }
  double operator()(const membrane::SpreadForce& force) const { return force.radius_A; }
  double operator()(const membrane::RigidSphere& sphere) const { return sphere.radius_A; }
  double operator()(const membrane::FollowerPressure&) const { return not_known; }
  double operator()(const membrane::EdgeMotion&) const { return not_known; }
};

}  // namespace

atomistic::Load atoms_load(const Case& c, LoadKind load) {
  switch (load) {
    case LoadKind::point:
      return atomistic::PointLoad{};
    case LoadKind::disc:
      return atomistic::DiscLoad{c.tip_radius_A};
    case LoadKind::sphere:
      return atomistic::SphereLoad{.radius_A = c.tip_radius_A};
    case LoadKind::pressure:
      return atomistic::PressureLoad{};
  }
  throw std::logic_error("a load that the atoms do not know");
}

membrane::Load nominal_load(const Case& c, LoadKind load) {
  switch (load) {
    case LoadKind::point:
      return membrane::PointLoad{};
    case LoadKind::disc:
      return disc_of(c.tip_radius_A);
    case LoadKind::sphere:
      return membrane::SphereLoad{c.tip_radius_A};
    case LoadKind::pressure:
      return membrane::PressureLoad{};
  }
  throw std::logic_error("a load that the membrane does not know");
}

membrane::Load twin_of(const Case& c, const PairedSheet& pair, LoadKind load) {
  switch (load) {
    case LoadKind::point:
    case LoadKind::disc:
      return disc_of(pair.effective_tip_A(atoms_load(c, load)));
    case LoadKind::sphere:
    case LoadKind::pressure:
      return nominal_load(c, load);
  }
  throw std::logic_error("a load without a twin");
}

double tip_radius_A(const membrane::Load& load) { return std::visit(TipRadius{}, membrane::action_of(load)); }

bool prescribes_force(const Case& c, LoadKind load) { return load == LoadKind::pressure || !c.forces_eV_per_A.empty(); }

}  // namespace validate
