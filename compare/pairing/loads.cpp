#include "compare/pairing/loads.hpp"

#include <stdexcept>

#include "compare/results/known.hpp"

namespace validate {

namespace {

membrane::Load disc_of(double radius_A) { return membrane::DiscLoad{radius_A}; }

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

double tip_radius_A(const membrane::Load& load) {
  if (const auto* disc = std::get_if<membrane::DiscLoad>(&load)) return disc->radius_A;
  const auto* sphere = std::get_if<membrane::SphereLoad>(&load);
  if (std::holds_alternative<membrane::PressureLoad>(load)) return not_known;
  return sphere ? sphere->radius_A : 0.0;
}

bool prescribes_force(const Case& c, LoadKind load) { return load == LoadKind::pressure || !c.forces_eV_per_A.empty(); }

}  // namespace validate
