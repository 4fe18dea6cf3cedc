// The indentation path: level after level, each started from the states before it and minimised.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "atomistic/lammps/lammps.hpp"
#include "atomistic/lattice/sheet.hpp"
#include "atomistic/problem.hpp"

namespace atomistic {

/// A level in progress.
struct Progress {
  int level = 0;
  int evaluations = 0;
  double max_force_eV_per_A = 0;
};

struct PathCallbacks {
  std::function<void(const Step&)> on_step;          ///< a finished level, converged or not
  std::function<void(const Progress&)> on_progress;  ///< once per iteration
};

/// The sheet of a problem: the clamped ring is as wide as the potential reaches.
Sheet make_sheet(const Problem& problem);

/// Holds the sheet at any depth that a path may reach.
Box box_around(const Sheet& sheet);

/// Follows the levels. `finished` holds the levels that an earlier run has already reached, in order; the
/// path goes on after them. With more than one MPI rank every rank calls this, with the same finished levels; only rank
/// 0 calls back and gets the report. Throws std::invalid_argument for a problem that makes no sense; not converging
/// ends the path, with a reason.
Report follow_path(const Problem& problem, const std::string& log_file, const std::vector<Step>& finished,
                   const PathCallbacks& callbacks, const MpiSession& session);

}  // namespace atomistic
