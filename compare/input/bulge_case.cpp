#include "compare/input/bulge_case.hpp"

#include <fmt/format.h>

#include <cmath>

#include "compare/base/errors.hpp"

namespace validate {

namespace {

constexpr double largest_atomistic_size_A = 2000;  // 1.5 million atoms

/// With atoms the membrane takes the potential's constants: one given on the command line would be lost.
void check_atoms(const BulgeCase& c, const Origins& origins) {
  for (const char* name : {"E", "nu"})
    if (label_of(origins, name) == fmt::format("--{}", name))
      throw bad_input("--{}: with a potential the membrane takes E·h and nu from the potential's card", name);
  if (!(c.size_A <= largest_atomistic_size_A))
    throw bad_input("{}: {} Å is too large for a sheet of atoms; at most {} Å", label_of(origins, "size"), c.size_A,
                    largest_atomistic_size_A);
}

}  // namespace

void check(const BulgeCase& c, const Origins& origins) {
  if (!c.potential.empty()) check_atoms(c, origins);
  if (c.pressures_eV_per_A3.empty())
    throw bad_input("{}: at least one pressure is needed", label_of(origins, "pressures"));
  if (c.cells != std::floor(c.cells))
    throw bad_input("{}: {} is not a whole number", label_of(origins, "cells"), c.cells);
  if (c.pretension_eV_per_A2 > 0 && c.edge == "sliding")
    throw bad_input("{}: an edge that slides cannot hold a pretension; use edge = \"clamped\"",
                    label_of(origins, "pretension"));
  if (c.shape == "disc" && c.edge == "sliding" && c.extent == "full")
    throw bad_input("{}: a full disc with a sliding rim can turn in its plane; use extent = \"quarter\"",
                    label_of(origins, "extent"));
  for (double p : c.pressures_eV_per_A3)
    if (p * c.size_A > 0.5 * c.E_eV_per_A3 * c.thickness_A)
      throw bad_input("{}: {} eV/Å³ over {} Å is beyond half of E × thickness: no such sheet stays whole",
                      label_of(origins, "pressures"), p, c.size_A);
}

membrane::Problem bulge_problem(const BulgeCase& c) {
  membrane::Problem problem;
  const auto support = c.edge == "clamped" ? membrane::Support::clamped : membrane::Support::sliding;
  const auto extent = c.extent == "quarter" ? membrane::Extent::quarter : membrane::Extent::full;
  const int cells = static_cast<int>(c.cells);
  if (c.shape == "disc") {
    problem.sheet = membrane::DiscSheet{.radius_A = c.size_A / 2,
                                        .rings = cells,
                                        .extent = extent,
                                        .spacing = membrane::RingSpacing::uniform,
                                        .rim = support};
  } else {
    problem.sheet = membrane::RectangleSheet{.length_x_A = c.size_A,
                                             .length_y_A = c.size_A,
                                             .cells_x = cells,
                                             .cells_y = cells,
                                             .extent = extent,
                                             .left = support,
                                             .right = support,
                                             .bottom = support,
                                             .top = support};
  }
  problem.law = membrane::StVenantKirchhoff{c.E_eV_per_A3 * c.thickness_A, c.nu};
  problem.prestress_eV_per_A2 = c.pretension_eV_per_A2 * Eigen::Matrix2d::Identity();
  problem.relaxed = !c.unrelaxed;
  problem.load = membrane::PressureLoad{};
  problem.control = membrane::Control::force;
  problem.levels = c.pressures_eV_per_A3;
  return problem;
}

}  // namespace validate
