// The atomistic program as the comparison sees it: jobs in, events out, several side by side.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "atomistic/protocol/event.hpp"
#include "atomistic/protocol/job.hpp"

namespace validate {

/// How LAMMPS is started.
struct AtomsLaunch {
  std::filesystem::path program;      ///< validate-atoms
  std::vector<std::string> launcher;  ///< words before it; empty: mpiexec where more than one rank is asked for
  int cores = 1;                      ///< that the runs may use together
};

struct AtomsJob {
  std::string name;  ///< names the job's folder below `work`
  atomistic::Job job;
  int ranks = 1;
};

/// How one job ended.
struct AtomsOutcome {
  bool finished = false;
  atomistic::Fault fault = atomistic::Fault::program;
  std::string failure;  ///< one message: LAMMPS's ERROR line, signal or status, where the log is
};

/// Cores that this process may use.
int available_cores();

/// What MPI and OpenMP are told unless the user has said otherwise: run as root in containers, share the cores with the
/// membrane, do not bind side-by-side runs to the same core, leave the core to others while waiting, and start no
/// daemon for a single rank (it would have to be in PATH). What MPI keeps on the disk goes into `session`, a folder of
/// this start alone: those that share one remove it under each other.
std::vector<std::pair<std::string, std::string>> mpi_environment(const std::filesystem::path& session);

/// Whether `mpiexec` can be found.
bool has_mpiexec();

/// Runs the jobs in `work`/<name>/, as many at a time as the cores allow, and hands out their events as they come.
/// A job that fails does not stop the others. Throws Error (interrupted) after stopping all when a signal has come.
std::vector<AtomsOutcome> run_jobs(const AtomsLaunch& launch, const std::vector<AtomsJob>& jobs,
                                   const std::filesystem::path& work,
                                   const std::function<void(std::size_t, const atomistic::Event&)>& on_event);

}  // namespace validate
