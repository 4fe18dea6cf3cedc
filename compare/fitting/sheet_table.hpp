// The membrane itself as a function that a fit can ask thousands of times: tabulated in its similarity variables.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/fitting/force_model.hpp"
#include "compare/fitting/sheet_physics.hpp"

namespace validate {

/// What a table covers.
struct TableRange {
  double deepest_A = 0;         ///< largest depth of record
  double Eh_eV_per_A2 = 0;      ///< about which it is made; exact for laws that scale with E·h and do not bend
  double pretension_share = 0;  ///< largest σ0h / E·h
  bool coarse = false;          ///< few nodes and no error: for differences of two tables
};

/// The finite-strain sheet on its meridian. F/(E·h a) depends on d/a and σ0h/E·h alone where the law scales with E·h
/// and nothing bends, else on E·h too. What is tabulated is the ratio to the shallow sheet (Föppl's disc, or for a
/// sphere the sum of its limits), which is smooth and near 1: a spline over ln d, a polynomial over ln(1 + s/s0) on
/// Chebyshev's points and, where it is needed, one over 1/E·h. `relative_error`, of the deepest force, is three
/// times (eight where the law ends) the largest difference to a sheet solved between the table's points, and what its
/// mesh makes. Below 1/50 of the largest depth the ratio goes to a constant; below no pretension, and beyond the
/// deepest, it is continued. Where the law ends before the deepest depth, `deepest_A` says so. Throws
/// std::runtime_error where the sheet is not solved.
ForceModel sheet_table(const MembraneTip& tip, const TableRange& range);

/// Forces (eV/Å) of a sheet at depths of record (Å), from a table. Throws std::runtime_error where they are not
/// reached.
std::vector<double> membrane_forces(const MembraneTip& tip, double Eh_eV_per_A2, double pretension_eV_per_A2,
                                    const std::vector<double>& depth_A);

/// A table's sheet with another tip: the difference of two coarse tables is added.
ForceModel with_tip(const ForceModel& table, const MembraneTip& tip, const MembraneTip& other, TableRange range);

}  // namespace validate
