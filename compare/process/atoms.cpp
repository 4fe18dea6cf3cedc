#include "compare/process/atoms.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <deque>
#include <fstream>
#include <list>
#include <optional>

#include "compare/base/child_process.hpp"
#include "compare/base/errors.hpp"
#include "compare/base/interrupt.hpp"
#include "compare/process/many_cases.hpp"

namespace validate {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> command_words(const AtomsLaunch& launch, int ranks, const fs::path& job_file) {
  std::vector<std::string> words = launch.launcher;
  if (words.empty() && ranks > 1) words = {"mpiexec", "-n", std::to_string(ranks)};
  words.push_back(launch.program.string());
  words.push_back(job_file.string());
  return words;
}

std::optional<std::string> line_with(const fs::path& file, std::string_view word) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (line.find(word) != std::string::npos) return line;
  return std::nullopt;
}

std::string last_lines(const fs::path& file, std::size_t count) {
  std::deque<std::string> lines;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.find_first_not_of(" \t-") == std::string::npos) continue;
    lines.push_back(line);
    if (lines.size() > count) lines.pop_front();
  }
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : " | ") + line;
  return text;
}

/// The last command that LAMMPS echoed into its log.
std::string last_command(const fs::path& log) {
  constexpr std::string_view commands[] = {"units",    "atom_style", "atom_modify", "boundary",   "processors",
                                           "region",   "create_box", "mass",        "pair_style", "pair_coeff",
                                           "neighbor", "thermo",     "run",         "change_box"};
  std::string last;
  std::ifstream in(log);
  for (std::string line; std::getline(in, line);)
    for (std::string_view command : commands)
      if (line.starts_with(command)) last = line;
  return last;
}

/// One job that runs.
struct RunningJob {
  std::size_t index;
  fs::path folder, log;
  ChildProcess child;
  bool ended_well = false;
  std::string error;  ///< what the program itself said
  atomistic::Fault fault = atomistic::Fault::program;

  std::string failure() {
    const ChildEnd end = child.wait();
    if (fault != atomistic::Fault::program) return error;
    if (const auto line = line_with(log, "ERROR"))
      return fmt::format("LAMMPS stopped: \"{}\" (last command: {}; log: {})", *line, last_command(log), log.string());
    if (!error.empty()) return fmt::format("validate-atoms stopped: {} (log: {})", error, log.string());
    const std::string how = end.signal ? fmt::format("was ended by signal {} ({})", end.signal, strsignal(end.signal))
                                       : fmt::format("ended with status {}", end.exit_code);
    const std::string said = last_lines(folder / "stderr", 8);
    const std::string command = last_command(log);
    return fmt::format("the atomistic program {}, without an ERROR line in {}{}{}", how, log.string(),
                       command.empty() ? "" : "; last command: " + command,
                       said.empty() ? "" : "; its standard error ends: " + said);
  }

  void note(const atomistic::Event& event) {
    if (std::holds_alternative<atomistic::EndEvent>(event)) ended_well = true;
    if (const auto* e = std::get_if<atomistic::ErrorEvent>(&event)) error = e->message, fault = e->fault;
  }
};

RunningJob start(const AtomsLaunch& launch, const AtomsJob& job, std::size_t index, const fs::path& work) {
  const fs::path folder = work / job.name;
  const fs::path job_file = folder / "job.json";
  try {
    fs::create_directories(folder);
    atomistic::write_job(job.job, job_file);
  } catch (const std::exception& e) {
    throw Error(ExitCode::file_failed, e.what());
  }
  return {.index = index,
          .folder = folder,
          .log = job.job.log_file,
          .child = ChildProcess({.words = command_words(launch, job.ranks, job_file),
                                 .folder = folder,
                                 .standard_error = folder / "stderr",
                                 .environment = mpi_environment()}),
          .ended_well = false,
          .error = {},
          .fault = atomistic::Fault::program};
}

void wait_for_output(std::list<RunningJob>& running) {
  std::vector<pollfd> descriptors;
  for (const RunningJob& job : running) descriptors.push_back({job.child.output(), POLLIN, 0});
  ::poll(descriptors.data(), descriptors.size(), 1000);
}

bool readable(const ChildProcess& child) {
  pollfd descriptor{child.output(), POLLIN, 0};
  return ::poll(&descriptor, 1, 0) > 0;
}

}  // namespace

int available_cores() { return static_cast<int>(usable_cores().size()); }

std::vector<std::pair<std::string, std::string>> mpi_environment() {
  std::vector<std::pair<std::string, std::string>> variables = {{"OMPI_MCA_rmaps_base_oversubscribe", "1"},
                                                                {"OMPI_MCA_hwloc_base_binding_policy", "none"},
                                                                {"OMPI_MCA_mpi_yield_when_idle", "1"},
                                                                {"OMPI_MCA_ess_singleton_isolated", "1"},
                                                                {"OMP_NUM_THREADS", "1"}};
  if (::geteuid() == 0) {
    variables.emplace_back("OMPI_ALLOW_RUN_AS_ROOT", "1");
    variables.emplace_back("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1");
  }
  return variables;
}

bool has_mpiexec() { return find_program("mpiexec").has_value(); }

std::vector<AtomsOutcome> run_jobs(const AtomsLaunch& launch, const std::vector<AtomsJob>& jobs, const fs::path& work,
                                   const std::function<void(std::size_t, const atomistic::Event&)>& on_event) {
  std::vector<AtomsOutcome> outcomes(jobs.size());
  std::list<RunningJob> running;
  std::size_t next = 0;
  int busy = 0;
  while (next < jobs.size() || !running.empty()) {
    while (next < jobs.size() && (running.empty() || busy + jobs[next].ranks <= launch.cores)) {
      running.push_back(start(launch, jobs[next], next, work));
      busy += jobs[next++].ranks;
    }
    wait_for_output(running);
    if (interrupted()) {
      for (RunningJob& job : running) job.child.stop();
      throw Error(ExitCode::interrupted, "interrupted");
    }
    for (RunningJob& job : running) {
      if (!readable(job.child)) continue;
      for (const std::string& line : job.child.read_lines()) {
        const atomistic::Event event = atomistic::event_from_line(line);
        job.note(event);
        on_event(job.index, event);
      }
    }
    running.remove_if([&](RunningJob& job) {
      if (job.child.output() >= 0) return false;
      outcomes[job.index].finished = job.child.wait().good() && job.ended_well;
      if (!outcomes[job.index].finished) outcomes[job.index].failure = job.failure();
      outcomes[job.index].fault = job.fault;
      busy -= jobs[job.index].ranks;
      return true;
    });
  }
  return outcomes;
}

}  // namespace validate
