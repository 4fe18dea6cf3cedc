#include "compare/process/atoms.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <deque>
#include <fstream>
#include <memory>
#include <optional>

#include "compare/base/child_process.hpp"
#include "compare/base/errors.hpp"
#include "compare/base/temporary_folder.hpp"
#include "compare/process/many_cases.hpp"
#include "compare/process/side_by_side.hpp"

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

/// What is known of a job that has been started.
struct StartedJob {
  fs::path folder, log;
  bool ended_well = false;
  std::string error;                                    ///< what the program itself said
  std::deque<std::string> others;                       ///< the last lines that were no events
  std::unique_ptr<const TemporaryFolder> session = {};  ///< of its MPI, while it runs
  atomistic::Fault fault = atomistic::Fault::program;

  std::string failure(const ChildEnd& end) const {
    if (fault != atomistic::Fault::program) return error;
    if (const auto line = line_with(log, "ERROR"))
      return fmt::format("LAMMPS stopped: \"{}\" (last command: {}; log: {})", *line, last_command(log), log.string());
    if (!error.empty()) return fmt::format("validate-atoms stopped: {} (log: {})", error, log.string());
    const std::string how = end.signal ? fmt::format("was ended by signal {} ({})", end.signal, strsignal(end.signal))
                                       : fmt::format("ended with status {}", end.exit_code);
    const std::string said = last_lines(folder / "stderr", 8);
    const std::string command = last_command(log), output = fmt::format("{}", fmt::join(others, " | "));
    return fmt::format("the atomistic program {}, without an ERROR line in {}{}{}{}", how, log.string(),
                       command.empty() ? "" : "; last command: " + command,
                       said.empty() ? "" : "; its standard error ends: " + said,
                       output.empty() ? "" : "; its standard output ends: " + output);
  }

  /// A launcher, or what a system loads before it, may print lines of its own.
  void note_other(const std::string& line) {
    constexpr std::size_t most = 4;
    others.push_back(line);
    if (others.size() > most) others.pop_front();
  }

  void note(const atomistic::Event& event) {
    if (std::holds_alternative<atomistic::EndEvent>(event)) ended_well = true;
    if (const auto* e = std::get_if<atomistic::ErrorEvent>(&event)) error = e->message, fault = e->fault;
  }
};

ChildProcess start(const AtomsLaunch& launch, const AtomsJob& job, const fs::path& folder, const fs::path& session) {
  const fs::path job_file = folder / "job.json";
  try {
    fs::create_directories(folder);
    atomistic::write_job(job.job, job_file);
  } catch (const std::exception& e) {
    throw Error(ExitCode::file_failed, e.what());
  }
  return ChildProcess({.words = command_words(launch, job.ranks, job_file),
                       .folder = folder,
                       .standard_error = folder / "stderr",
                       .environment = mpi_environment(session)});
}

}  // namespace

int available_cores() { return static_cast<int>(usable_cores().size()); }

std::vector<std::pair<std::string, std::string>> mpi_environment(const fs::path& session) {
  std::vector<std::pair<std::string, std::string>> variables = {
      {"OMPI_MCA_rmaps_base_oversubscribe", "1"},      {"OMPI_MCA_hwloc_base_binding_policy", "none"},
      {"OMPI_MCA_mpi_yield_when_idle", "1"},           {"OMPI_MCA_ess_singleton_isolated", "1"},
      {"OMPI_MCA_orte_tmpdir_base", session.string()}, {"OMP_NUM_THREADS", "1"}};
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
  std::vector<StartedJob> started;
  std::vector<int> ranks;
  for (const AtomsJob& job : jobs) {
    started.push_back({.folder = work / job.name, .log = job.job.log_file});
    ranks.push_back(job.ranks);
  }
  run_side_by_side(ranks, launch.cores,
                   {.start =
                        [&](std::size_t i) {
                          started[i].session = std::make_unique<const TemporaryFolder>("validate-mpi");
                          return start(launch, jobs[i], started[i].folder, started[i].session->path());
                        },
                    .on_line =
                        [&](std::size_t i, const std::string& line) {
                          const auto event = atomistic::event_in_line(line);
                          if (!event) return started[i].note_other(line);
                          started[i].note(*event);
                          on_event(i, *event);
                        },
                    .on_end =
                        [&](std::size_t i, const ChildEnd& end) {
                          started[i].session.reset();
                          outcomes[i] = {.finished = end.good() && started[i].ended_well, .fault = started[i].fault};
                          if (!outcomes[i].finished) outcomes[i].failure = started[i].failure(end);
                        }});
  return outcomes;
}

}  // namespace validate
