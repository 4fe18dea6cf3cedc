// validate-atoms: computes one job through LAMMPS. Started by validate, under mpiexec or alone.
//
// What was standard output carries one event per line, and nothing else: what libraries print goes to standard error.
// When its reader is gone the next line cannot be written and every rank ends: nothing runs on without somebody to take
// the result.
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <system_error>

#include "atomistic/cell/card.hpp"
#include "atomistic/cell/response.hpp"
#include "atomistic/cell/warm_card.hpp"
#include "atomistic/equilibrium/indentation.hpp"
#include "atomistic/lammps/forces.hpp"
#include "atomistic/lammps/lammps.hpp"
#include "atomistic/protocol/event.hpp"
#include "atomistic/protocol/heat_file.hpp"
#include "atomistic/protocol/job.hpp"
#include "atomistic/protocol/math_threads.hpp"
#include "atomistic/protocol/step_file.hpp"
#include "atomistic/thermal/quasi_harmonic.hpp"
#include "atomistic/thermal/sampling.hpp"

namespace {

using namespace atomistic;

/// The descriptor that events go to.
int events = -1;

void keep_events_apart() {
  events = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  if (events < 0 || ::dup2(STDERR_FILENO, STDOUT_FILENO) < 0)
    throw std::system_error(errno, std::generic_category(), "standard output");
}

void tell(const Event& event) {
  const std::string line = to_line(event) + '\n';
  for (std::size_t done = 0; done < line.size();) {
    const ssize_t written = ::write(events, line.data() + done, line.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) MpiSession::abort(1);
    done += static_cast<std::size_t>(written);
  }
}

Fault fault_of(const std::exception& e) {
  if (dynamic_cast<const BadPotential*>(&e)) return Fault::bad_input;
  if (dynamic_cast<const std::bad_alloc*>(&e)) return Fault::memory;
  return dynamic_cast<const std::system_error*>(&e) ? Fault::file : Fault::program;
}

std::string message_of(const std::exception& e) {
  if (fault_of(e) != Fault::memory) return e.what();
  return "there is not enough memory; --preconditioner multigrid needs half of what a factor does, and a --launcher "
         "spreads it over several machines; the steps before this one are kept, --resume goes on from them";
}

struct Worker {
  const MpiSession& session;
  const std::string& log_file;

  /// Its cells are small: rank 0 computes it, whatever number a launcher has started.
  void operator()(const CardJob& job) const {
    if (session.rank() != 0) return;
    tell(CardEvent{compute_card(job.potential, log_file)});
    tell(EndEvent{});
  }

  void operator()(const ResponseJob& job) const {
    if (session.rank() != 0) return;
    tell(ResponseEvent{compute_response(job.potential, job.card, job.strains, log_file)});
    tell(EndEvent{});
  }

  void operator()(const ForcesJob& job) const {
    const std::vector<AtomForces> states = compute_forces(job.potential, job.positions, log_file, session);
    if (session.rank() != 0) return;
    tell(ForcesEvent{states});
    tell(EndEvent{});
  }

  void operator()(const CurveJob& job) const {
    const PathCallbacks callbacks{.on_step =
                                      [&](const Step& step) {
                                        write_step(step, job.steps_folder);
                                        tell(StepEvent{step.level, step_file_name(step.level).string()});
                                      },
                                  .on_progress =
                                      [](const Progress& p) {
                                        tell(ProgressEvent{p.level, p.evaluations, p.max_force_eV_per_A});
                                      }};
    const auto finished = read_finished_steps(job.steps_folder);
    const Report report = follow_path(job.problem, log_file, finished, callbacks, session);
    if (session.rank() == 0) tell(EndEvent{report});
  }

  void operator()(const WarmJob& job) const {
    if (session.rank() != 0) return;
    tell(WarmEvent{compute_warm_card(job.potential, job.card, job.heat, log_file),
                   vibrations_under_strain(job.potential, job.card, job.heat, job.strains, log_file)});
    tell(EndEvent{});
  }

  void operator()(const SampleJob& job) const {
    const auto keep = [&](const Sampled& s) {
      write_sampled(s, job.steps_folder);
      tell(SampleEvent{s.level, s.length_ps, s.mean_depth_A, s.error_A});
    };
    const Step step = read_step(std::filesystem::path(job.steps_folder) / step_file_name(job.level));
    sample_level(job.problem, step, job.sampling, log_file, read_sampled(job.level, job.steps_folder), keep);
    tell(EndEvent{});
  }

  /// Levels that an earlier run has finished are told of first.
  void operator()(const HeatJob& job) const {
    std::vector<Step> steps;
    std::vector<int> done;
    if (session.rank() == 0) {
      steps = read_equilibria(job.steps_folder);
      for (const Step& step : steps)
        if (read_heated_level(step.level, job.steps_folder)) done.push_back(step.level);
    }
    for (const int level : done) tell(HeatEvent{level});
    const auto on_level = [&](const HeatedLevel& level) {
      write_heated_level(level, job.steps_folder);
      tell(HeatEvent{level.level});
    };
    heat_levels(job.problem, steps, job.heat, log_file, done, on_level, session);
    if (session.rank() == 0) tell(EndEvent{});
  }
};

}  // namespace

int main(int argc, char** argv) {
  signal(SIGPIPE, SIG_IGN);  // seen as a failed write instead,
  signal(SIGXFSZ, SIG_IGN);  // and so is a file above the limit
  MpiSession session(&argc, &argv);
  const int release = lammps_release();
  if (argc == 2 && std::string(argv[1]) == "--version") {
    if (session.rank() == 0) std::cout << release << std::endl;
    return 0;
  }
  if (argc != 2) {
    std::cerr << "usage: validate-atoms JOB.json (started by validate)\n";
    return 2;
  }
  try {
    keep_events_apart();
    use_one_math_thread();
    const Job job = read_job(argv[1]);
    if (session.rank() == 0) tell(StartEvent{release, session.ranks()});
    std::visit(Worker{session, job.log_file}, job.work);
    return 0;
  } catch (const std::exception& e) {
    if (session.rank() == 0) tell(ErrorEvent{message_of(e), fault_of(e)});
    std::cerr << "validate-atoms: " << message_of(e) << std::endl;
    if (session.ranks() > 1) MpiSession::abort(1);
    return 1;
  }
}
