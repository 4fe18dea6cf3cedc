// The case of `validate bulge`: a sheet under a follower pressure.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "compare/base/describe.hpp"
#include "compare/base/field_value.hpp"
#include "membrane/problem.hpp"

namespace validate {

inline constexpr std::array<std::string_view, 2> shape_names = {"disc", "square"};
inline constexpr std::array<std::string_view, 2> edge_names = {"clamped", "sliding"};
inline constexpr std::array<std::string_view, 2> extent_names = {"quarter", "full"};

struct BulgeCase {
  std::string shape = "square";
  double size_A = 220;  ///< side of the square, diameter of the disc
  std::string edge = "sliding";
  std::vector<double> pressures_eV_per_A3 = {5.16529e-4};
  double E_eV_per_A3 = 5.864, thickness_A = 1.37, nu = 0.19;
  double pretension_eV_per_A2 = 0;
  std::string extent = "quarter";
  double cells = 60;  ///< rings of a disc; grid cells along a side of the meshed part of a square
  bool unrelaxed = false;
  std::string potential;  ///< of the atoms beside the membrane; empty: no atoms
};

template <class Self, class Visitor>
requires SameStruct<Self, BulgeCase>
void describe(Self& c, Visitor&& visit) {
  visit(Field{.name = "shape", .meaning = "shape of the sheet", .choices = shape_names}, c.shape);
  visit(Field{"size", unit::length, "side of the square, diameter of the disc", positive()}, c.size_A);
  visit(Field{.name = "edge", .meaning = "clamped, or sliding in its plane", .choices = edge_names}, c.edge);
  visit(Field{"pressures", unit::stress, "follower pressures, in the order of the path", positive()},
        c.pressures_eV_per_A3);
  visit(Field{"E", unit::stress, "Young's modulus", positive()}, c.E_eV_per_A3);
  visit(Field{"thickness", unit::length, "thickness that goes with E", positive()}, c.thickness_A);
  visit(Field{"nu", {}, "Poisson's ratio", between(-1, 1)}, c.nu);
  visit(Field{"pretension", unit::membrane_force, "isotropic membrane force of the flat sheet", not_negative()},
        c.pretension_eV_per_A2);
  visit(Field{.name = "extent", .meaning = "part that is meshed", .choices = extent_names}, c.extent);
  visit(Field{"cells", {}, "rings of a disc, cells along a side of a square's meshed part", from_to(8, 500)}, c.cells);
  visit(Field{"unrelaxed", {}, "let the sheet bear compression: what the paper's relaxation removes"}, c.unrelaxed);
  visit(Field{"potential",
              {},
              "the same sheet as atoms beside it (name in inputs/potentials, or path); E and nu are its own"},
        c.potential);
}

/// Relations between fields. Throws Error (bad input).
void check(const BulgeCase& c, const Origins& origins);

/// The sheet as the solver is asked for it.
membrane::Problem bulge_problem(const BulgeCase& c);

}  // namespace validate
