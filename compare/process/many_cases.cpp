#include "compare/process/many_cases.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sched.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <list>
#include <set>

#include "compare/base/child_process.hpp"
#include "compare/base/errors.hpp"
#include "compare/base/interrupt.hpp"
#include "compare/process/run_folder.hpp"

namespace validate {
namespace {

namespace fs = std::filesystem;

/// What is started while this lives runs on these cores.
class OnCores {
 public:
  explicit OnCores(const std::vector<int>& cores) {
    valid_ = ::sched_getaffinity(0, sizeof before_, &before_) == 0;
    cpu_set_t set;
    CPU_ZERO(&set);
    for (const int core : cores) CPU_SET(core, &set);
    if (valid_) ::sched_setaffinity(0, sizeof set, &set);
  }
  ~OnCores() {
    if (valid_) ::sched_setaffinity(0, sizeof before_, &before_);
  }
  OnCores(const OnCores&) = delete;
  OnCores& operator=(const OnCores&) = delete;

 private:
  cpu_set_t before_{};
  bool valid_ = false;
};

std::string last_line(const fs::path& log) {
  std::ifstream in(log);
  std::string last;
  for (std::string line; std::getline(in, line);)
    if (line.find_first_not_of(" \t") != std::string::npos) last = line;
  return last;
}

CaseEnd end_of_case(const ChildEnd& end, const fs::path& log, double seconds) {
  if (end.signal)
    return {.exit_code = 128 + end.signal,
            .seconds = seconds,
            .reason = fmt::format("ended by signal {} ({})", end.signal, strsignal(end.signal))};
  const bool verdict =
      end.exit_code == static_cast<int>(ExitCode::success) || end.exit_code == static_cast<int>(ExitCode::disagreement);
  return {.exit_code = end.exit_code, .seconds = seconds, .reason = verdict ? "" : last_line(log)};
}

struct RunningCase {
  std::size_t index;
  std::vector<int> cores;
  double started;
  ChildProcess child;
};

class CasePool {
 public:
  CasePool(const std::vector<ManyCase>& cases, bool resume, Progress& progress, const std::vector<int>& cores)
      : cases_(cases), resume_(resume), progress_(progress), free_(cores.begin(), cores.end()), ends_(cases.size()) {
    all_ = free_.size();
  }

  std::vector<CaseEnd> run() {
    while (next_ < cases_.size() || !running_.empty()) {
      while (next_ < cases_.size() && start_next()) ++next_;
      if (running_.empty()) continue;
      wait_for_output();
      if (interrupted()) stop_all();
      running_.remove_if([&](RunningCase& c) { return has_ended(c); });
    }
    return ends_;
  }

 private:
  /// Whether the next case needs no more waiting.
  bool start_next() {
    const ManyCase& c = cases_[next_];
    if (const auto code = finished_exit_code(c.folder); resume_ && code) {
      ends_[next_] = {.exit_code = *code, .seconds = 0, .reason = "", .finished_before = true};
      progress_.say(fmt::format("{}: finished before", c.name));
      return true;
    }
    const std::size_t wanted = std::clamp<std::size_t>(static_cast<std::size_t>(std::max(c.cores, 1)), 1, all_);
    if (wanted > free_.size()) return false;
    start(c, std::vector<int>(free_.begin(), std::next(free_.begin(), static_cast<std::ptrdiff_t>(wanted))));
    return true;
  }

  void start(const ManyCase& c, const std::vector<int>& cores) {
    std::vector<std::string> words = c.words;
    words.insert(words.end(), {"--out", c.folder.string(), "--quiet"});
    if (resume_ && is_resumable(c.folder)) words.push_back("--resume");
    const OnCores only(cores);
    try {
      running_.push_back({next_, cores, seconds(),
                          ChildProcess({.words = words,
                                        .standard_error = c.log,
                                        .environment = {{"OMP_NUM_THREADS", std::to_string(cores.size())}}})});
    } catch (const Error& error) {
      ends_[next_] = {.exit_code = static_cast<int>(error.exit_code()), .seconds = 0, .reason = error.what()};
      progress_.say(fmt::format("{}: {}", c.name, error.what()));
      return;
    }
    for (const int core : cores) free_.erase(core);
    progress_.say(fmt::format("{}: started", c.name));
  }

  /// Reads what they print, so that none waits for a full pipe; its numbers are in its documents.
  void wait_for_output() {
    std::vector<pollfd> descriptors;
    for (const RunningCase& c : running_) descriptors.push_back({c.child.output(), POLLIN, 0});
    ::poll(descriptors.data(), descriptors.size(), 1000);
    std::size_t i = 0;
    for (RunningCase& c : running_)
      if (descriptors[i++].revents != 0) c.child.read_lines();
  }

  void stop_all() {
    for (RunningCase& c : running_) c.child.ask_to_stop();
    for (RunningCase& c : running_) c.child.stop();
    throw Error(ExitCode::interrupted, "interrupted");
  }

  bool has_ended(RunningCase& c) {
    if (c.child.output() >= 0) return false;
    const ManyCase& of = cases_[c.index];
    ends_[c.index] = end_of_case(c.child.wait(), of.log, seconds() - c.started);
    free_.insert(c.cores.begin(), c.cores.end());
    progress_.say(fmt::format("{}: ended with exit code {}", of.name, ends_[c.index].exit_code));
    return true;
  }

  const std::vector<ManyCase>& cases_;
  bool resume_;
  Progress& progress_;
  std::set<int> free_;
  std::size_t all_ = 0, next_ = 0;
  std::list<RunningCase> running_;
  std::vector<CaseEnd> ends_;
};

}  // namespace

std::vector<int> usable_cores() {
  cpu_set_t set;
  std::vector<int> all;
  if (::sched_getaffinity(0, sizeof set, &set) == 0)
    for (int i = 0; i < CPU_SETSIZE; ++i)
      if (CPU_ISSET(i, &set)) all.push_back(i);
  return all.empty() ? std::vector<int>{0} : all;
}

std::vector<CaseEnd> run_cases(const std::vector<ManyCase>& cases, bool resume, Progress& progress,
                               const std::vector<int>& cores) {
  return CasePool(cases, resume, progress, cores).run();
}

}  // namespace validate
