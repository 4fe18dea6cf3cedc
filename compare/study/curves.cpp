#include "compare/study/curves.hpp"

#include <algorithm>
#include <vector>

namespace validate {

namespace {

/// The last point's load is a pressure: its force and conjugate depth are those of the flat area.
void press(Run& run, double pressure_eV_per_A3, double volume_A3, double flat_area_A2) {
  run.pressure_eV_per_A3.push_back(pressure_eV_per_A3);
  run.volume_A3.push_back(volume_A3);
  run.force_eV_per_A.back() = pressure_eV_per_A3 * flat_area_A2;
  run.conjugate_depth_A.back() = volume_A3 / flat_area_A2;
}

/// Of a sheet whose rim is pulled: where it is wrinkled, or bears compression.
void append_tautness(Run& run, const membrane::Step& step) {
  ContinuumPart& part = run.continuum();
  run.rim_displacement_A.push_back(step.rim_displacement_A);
  part.wrinkled_area_fraction.push_back(step.tautness.wrinkled_area_fraction);
  part.slack_area_fraction.push_back(step.tautness.slack_area_fraction);
  part.compressed_area_fraction.push_back(step.tautness.compressed_area_fraction);
  part.least_membrane_force_eV_per_A2.push_back(step.tautness.least_force_eV_per_A2);
}

}  // namespace

void append(Run& run, const membrane::Step& step) {
  run.depth_A.push_back(step.depth_A);
  run.conjugate_depth_A.push_back(step.conjugate_depth_A);
  run.force_eV_per_A.push_back(step.force_eV_per_A);
  run.energy_eV.push_back(step.energy_eV);
  run.converged.push_back(step.converged);
  run.continuum().newton_iterations.push_back(step.newton_iterations);
  if (run.load == LoadKind::pressure)
    press(run, step.pressure_eV_per_A3, step.volume_A3, step.volume_A3 / step.conjugate_depth_A);
  if (run.compression) append_tautness(run, step);
}

void append(Run& run, const Wrinkles& wrinkles) {
  run.wrinkle_count.push_back(wrinkles.count);
  run.wrinkle_wavelength_A.push_back(wrinkles.count > 0 ? wrinkles.wavelength_A : not_known);
  run.wrinkle_amplitude_A.push_back(wrinkles.amplitude_A);
}

namespace {

/// Green–Lagrange strain counted from the lattice at rest, of a sheet that was stretched when flat.
double from_rest(double strain, double stretch) { return stretch * stretch * strain + (stretch * stretch - 1) / 2; }

double longest(const LongestBond& bond, const std::vector<membrane::MeridianPoint>& points, double stretch) {
  double found = bond.rest_A;
  for (const auto& p : points)
    found = std::max(found, bond(from_rest(p.radial_strain, stretch), from_rest(p.hoop_strain, stretch)));
  return found;
}

}  // namespace

void append(Run& run, const membrane::Step& step, const std::optional<LongestBond>& longest_bond, double stretch) {
  append(run, step);
  if (longest_bond) run.longest_bond_A.push_back(longest(*longest_bond, step.on_meridian(), stretch));
}

void append(Run& run, const atomistic::Step& step, double artefact_from_A, bool broken) {
  run.depth_A.push_back(step.depth_A);
  run.conjugate_depth_A.push_back(step.conjugate_depth_A);
  run.force_eV_per_A.push_back(step.force_eV_per_A);
  run.energy_eV.push_back(step.energy_eV);
  run.converged.push_back(step.converged && !broken);
  run.longest_bond_A.push_back(step.longest_bond_A);
  if (run.load == LoadKind::pressure) {
    const double flat_area_A2 = step.force_eV_per_A / step.target;
    press(run, step.target, step.conjugate_depth_A * flat_area_A2, flat_area_A2);
  }
  AtomsPart& part = run.atoms();
  part.max_force_eV_per_A.push_back(step.max_force_eV_per_A);
  part.balance_relative.push_back(step.balance_relative);
  part.force_error_relative.push_back(step.force_error_relative);
  part.artefact.push_back(!broken && step.longest_bond_A >= artefact_from_A);
  part.force_evaluations.push_back(step.evaluations);
  part.factorisations.push_back(step.factorisations);
  part.solves.push_back(step.solves);
}

namespace {

double trapezoids(const std::vector<double>& x, const std::vector<double>& y, std::size_t first) {
  double sum = 0;
  for (std::size_t k = first + 1; k < x.size(); ++k) sum += (x[k] - x[k - 1]) * (y[k] + y[k - 1]) / 2;
  return sum;
}

}  // namespace

Unloading unloading_of(const Run& run, const std::vector<atomistic::Step>& steps) {
  Unloading back;
  back.load = run.load;
  for (const atomistic::Step& step : steps) {
    if (!step.unloading || !step.converged) continue;
    back.depth_A.push_back(step.depth_A);
    back.conjugate_depth_A.push_back(step.conjugate_depth_A);
    back.force_eV_per_A.push_back(step.force_eV_per_A);
  }
  const std::size_t returned = back.depth_A.size(), loaded = run.depth_A.size();
  if (returned == 0 || loaded <= returned) return back;
  std::vector<double> d = back.conjugate_depth_A, f = back.force_eV_per_A;
  d.insert(d.begin(), run.conjugate_depth_A.back());
  f.insert(f.begin(), run.force_eV_per_A.back());
  const double there = trapezoids(run.conjugate_depth_A, run.force_eV_per_A, loaded - 1 - returned);
  back.hysteresis_relative = (there + trapezoids(d, f, 0)) / there;
  return back;
}

void close(Run& run, const membrane::Report& report) {
  run.continuum().factorisations = report.factorisations;
  run.ended = report.converged ? Ended::depth_max : Ended::not_converged;
  run.ended_reason = report.reason;
}

void close(Run& run, const atomistic::Report& report) {
  switch (report.ended) {
    case atomistic::Ended::depth_max:
      run.ended = Ended::depth_max;
      break;
    case atomistic::Ended::artefact:
      run.ended = Ended::artefact;
      break;
    case atomistic::Ended::rupture:
      run.ended = Ended::rupture;
      break;
    case atomistic::Ended::not_converged:
      run.ended = Ended::not_converged;
      break;
  }
  run.ended_reason = report.reason;
  run.atoms().preconditioner = report.preconditioning == atomistic::Preconditioning::multigrid
                                   ? Preconditioner::multigrid
                                   : Preconditioner::factor;
  if (const auto& c = report.contact)
    run.atoms().contact = {c->force_change_relative, c->depth_change_A, c->force_change_at_equal_depth_relative,
                           c->deepest_penetration_A};
}

}  // namespace validate
