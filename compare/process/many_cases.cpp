#include "compare/process/many_cases.hpp"

#include <fmt/format.h>
#include <sched.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <set>

#include "compare/base/errors.hpp"
#include "compare/process/run_folder.hpp"
#include "compare/process/side_by_side.hpp"

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

class CasePool {
 public:
  CasePool(const std::vector<ManyCase>& cases, bool resume, Progress& progress, const std::vector<int>& cores)
      : cases_(cases), resume_(resume), progress_(progress), free_(cores.begin(), cores.end()), ends_(cases.size()) {
    const int all = static_cast<int>(cores.size());
    for (std::size_t i = 0; i < cases.size(); ++i)
      wanted_.push_back(was_finished(i) ? 0 : std::clamp(cases[i].cores, 1, all));
    used_.resize(cases.size());
  }

  std::vector<CaseEnd> run() {
    run_side_by_side(wanted_, static_cast<int>(free_.size()),
                     {.start = [this](std::size_t i) { return start(i); },
                      .on_end = [this](std::size_t i, const ChildEnd& end) { note(i, end); }});
    return ends_;
  }

 private:
  bool was_finished(std::size_t i) {
    const auto code = resume_ ? finished_exit_code(cases_[i].folder) : std::nullopt;
    if (code) ends_[i] = {.exit_code = *code, .seconds = 0, .reason = "", .finished_before = true};
    return code.has_value();
  }

  std::optional<ChildProcess> start(std::size_t i) {
    const ManyCase& c = cases_[i];
    if (ends_[i].finished_before) {
      progress_.say(fmt::format("{}: finished before", c.name));
      return std::nullopt;
    }
    std::vector<std::string> words = c.words;
    words.insert(words.end(), {"--out", c.folder.string(), "--quiet"});
    if (resume_ && is_resumable(c.folder)) words.push_back("--resume");
    const std::vector<int> cores(free_.begin(), std::next(free_.begin(), wanted_[i]));
    const OnCores only(cores);
    try {
      ChildProcess child({.words = words,
                          .standard_error = c.log,
                          .environment = {{"OMP_NUM_THREADS", std::to_string(cores.size())}}});
      for (const int core : cores) free_.erase(core);
      used_[i] = cores;
      ends_[i].seconds = seconds();
      progress_.say(fmt::format("{}: started", c.name));
      return child;
    } catch (const Error& error) {
      ends_[i] = {.exit_code = static_cast<int>(error.exit_code()), .seconds = 0, .reason = error.what()};
      progress_.say(fmt::format("{}: {}", c.name, error.what()));
      return std::nullopt;
    }
  }

  void note(std::size_t i, const ChildEnd& end) {
    ends_[i] = end_of_case(end, cases_[i].log, seconds() - ends_[i].seconds);
    free_.insert(used_[i].begin(), used_[i].end());
    progress_.say(fmt::format("{}: ended with exit code {}", cases_[i].name, ends_[i].exit_code));
  }

  const std::vector<ManyCase>& cases_;
  bool resume_;
  Progress& progress_;
  std::set<int> free_;
  std::vector<int> wanted_;             ///< cores a case, 0 where there is nothing to run
  std::vector<std::vector<int>> used_;  ///< cores that it runs on
  std::vector<CaseEnd> ends_;           ///< of what runs: seconds hold when it began
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
