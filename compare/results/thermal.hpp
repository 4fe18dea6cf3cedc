// What a temperature does to a curve and to the flat sheet, beside their numbers at T = 0.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/base/describe.hpp"
#include "compare/input/case.hpp"
#include "compare/results/known.hpp"

namespace validate {

/// The flat sheet, by the phonons of its cell.
struct WarmSheet {
  double temperature_K = not_known;
  Statistics statistics = Statistics::classical;
  double lattice_constant_A = not_known;
  double stretch = not_known;  ///< lattice constant over that at T = 0, less 1
  double Eh_eV_per_A2 = not_known, nu = not_known;
  double longest_wave_A = not_known;  ///< of the flexural waves that count
};

void describe(SameStruct<WarmSheet> auto& sheet, auto&& visit) {
  visit(Field{"temperature", unit::kelvin, "of the sheet"}, sheet.temperature_K);
  visit(Field{"statistics", unit::none, "of its vibrations"}, sheet.statistics);
  visit(Field{"lattice_constant", unit::length, "where the free energy of a flat cell is least"},
        sheet.lattice_constant_A);
  visit(Field{"stretch", unit::none, "lattice constant over that at T = 0, less 1"}, sheet.stretch);
  visit(Field{"Eh", unit::membrane_force, "isothermal sheet modulus there"}, sheet.Eh_eV_per_A2);
  visit(Field{"nu", unit::none, "Poisson's ratio there"}, sheet.nu);
  visit(Field{"longest_wave", unit::length, "flexural waves longer than this are left to the drum that they run in"},
        sheet.longest_wave_A);
}

/// Langevin dynamics under the run's forces. Columns are as long as the run's; a level that was not sampled has length
/// 0.
struct Dynamics {
  std::vector<double> mean_A, error_A, samples, warm_up_ps, correlation_ps, length_ps;
};

void describe(SameStruct<Dynamics> auto& md, auto&& visit) {
  visit(Column{"mean", unit::length, "mean conjugate depth at the run's force, less that at T = 0"}, md.mean_A);
  visit(Column{"error", unit::length, "its standard error, by the autocorrelation"}, md.error_A);
  visit(Column{"samples", unit::none, "independent ones that the series is worth"}, md.samples);
  visit(Column{"warm_up", unit::picosecond, "left out at the start"}, md.warm_up_ps);
  visit(Column{"correlation", unit::picosecond, "integrated autocorrelation time"}, md.correlation_ps);
  visit(Column{"length", unit::picosecond, "sampled, the warm-up included"}, md.length_ps);
}

/// What Eq. 16 reads from a curve.
struct Eq16Reading {
  double Eh_eV_per_A2 = not_known, pretension_eV_per_A2 = not_known;
};

void describe(SameStruct<Eq16Reading> auto& reading, auto&& visit) {
  visit(Field{"Eh", unit::membrane_force, "sheet modulus"}, reading.Eh_eV_per_A2);
  visit(Field{"pretension", unit::membrane_force, "pretension"}, reading.pretension_eV_per_A2);
}

/// The columns are as long as those of the run that holds it; numbers of a depth that could not be heated are not
/// known.
struct Thermal {
  double temperature_K = not_known;
  Statistics statistics = Statistics::classical;
  Rim rim = Rim::at_rest;
  double rim_strain = not_known;  ///< by which the rim's lattice is stretched from where it is at T = 0

  std::vector<double> depth_shift_A, force_ratio, lowest_eigenvalue_eV_per_A2;
  std::vector<bool> stable;
  std::vector<double> sheet_shift_by_cell_A, sheet_shift_by_waves_A, sheet_force_ratio;
  std::string unstable;  ///< where the sheet is, and by which mode

  std::optional<Dynamics> md;
  std::optional<Eq16Reading> cold, warm;
  double hessian_error_relative = not_known, seconds_per_depth = not_known;
};

void describe(SameStruct<Thermal> auto& thermal, auto&& visit) {
  visit(Field{"temperature", unit::kelvin, "of the sheet"}, thermal.temperature_K);
  visit(Field{"statistics", unit::none, "of its vibrations"}, thermal.statistics);
  visit(Field{"rim", unit::none, "static: at the lattice constant of T = 0; thermal: at that of the temperature"},
        thermal.rim);
  visit(Field{"rim_strain", unit::none, "by which the rim is stretched from its place at T = 0"}, thermal.rim_strain);
  visit(Column{"depth_shift", unit::length, "mean conjugate depth at the run's force, less that at T = 0"},
        thermal.depth_shift_A);
  visit(Column{"force_ratio", unit::none, "mean force at the run's conjugate depth, over that at T = 0"},
        thermal.force_ratio);
  visit(Column{"lowest_eigenvalue", unit::membrane_force, "of the Hessian; negative: no equilibrium"},
        thermal.lowest_eigenvalue_eV_per_A2);
  visit(Column{"stable", unit::none, "every vibration has a positive eigenvalue"}, thermal.stable);
  visit(Column{"sheet_shift_by_cell", unit::length,
               "of the calibrated sheet's depth by the cell's phonons, its rim static"}
            .where_known(),
        thermal.sheet_shift_by_cell_A);
  visit(Column{"sheet_shift_by_waves", unit::length, "of that depth by the sheet's own long waves"}.where_known(),
        thermal.sheet_shift_by_waves_A);
  visit(Column{"sheet_force_ratio", unit::none, "force of the atoms over that of the sheet, both at the temperature"}
            .where_known(),
        thermal.sheet_force_ratio);
  visit(Field{"unstable", unit::none, "where the sheet is not stable, and by which mode"}.where_known(),
        thermal.unstable);
  visit(Field{"md", unit::none, "the shift by Langevin dynamics"}.where_known(), thermal.md);
  visit(
      Field{"eq16_cold", unit::none, "what Eq. 16 reads at T = 0, from the depths that could be heated"}.where_known(),
      thermal.cold);
  visit(Field{"eq16_warm", unit::none, "what it reads there at the temperature"}.where_known(), thermal.warm);
  visit(Field{"hessian_error_relative", unit::none, "largest, along a random direction"},
        thermal.hessian_error_relative);
  visit(Field{"seconds_per_depth", unit::second, "mean"}, thermal.seconds_per_depth);
}

}  // namespace validate
