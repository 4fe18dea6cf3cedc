#include "compare/cli/batch.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sched.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <list>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "compare/base/child_process.hpp"
#include "compare/base/errors.hpp"
#include "compare/base/file.hpp"
#include "compare/base/interrupt.hpp"
#include "compare/base/paths.hpp"
#include "compare/base/progress.hpp"
#include "compare/documents/texts/summary_json.hpp"

namespace validate {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

fs::path batch_folder(const RunOptions& options) {
  if (options.out) return fs::absolute(*options.out);
  const auto numbered = [](int n) {
    return fs::path("runs") / (n == 1 ? "indentation-batch" : fmt::format("indentation-batch-{}", n));
  };
  int n = 1;
  while (fs::exists(numbered(n))) ++n;
  return fs::absolute(numbered(options.resume && n > 1 ? n - 1 : n));
}

std::string case_name(const BatchCase& c) {
  return fmt::format("{}-R{:g}", fs::path(c.potential).stem().string(), c.radius_A);
}

bool is_finished(const fs::path& folder) { return fs::exists(folder / "summary.json") && !fs::exists(folder / "work"); }

bool is_batch(const fs::path& folder) {
  std::ifstream in(folder / "batch.json");
  return in.good();
}

void prepare(const fs::path& folder, const std::vector<BatchCase>& cases, const RunOptions& options) {
  const bool exists = fs::exists(folder) && !(fs::is_directory(folder) && fs::is_empty(folder));
  if (exists && !is_batch(folder))
    throw bad_input("--out: '{}' exists and does not hold a batch of this program; choose another folder",
                    folder.string());
  if (exists && !options.resume && !options.overwrite)
    throw bad_input("--out: '{}' holds a batch; --resume goes on with it, --overwrite starts again", folder.string());
  if (!exists && options.resume) throw bad_input("--resume: '{}' holds no batch", folder.string());
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw Error(ExitCode::file_failed, fmt::format("cannot create '{}': {}", folder.string(), error.message()));
  Json list = Json::array();
  for (const BatchCase& c : cases) list.push_back(case_name(c));
  write_file(folder / "batch.json", Json{{"schema", summary_schema}, {"cases", list}}.dump(1) + "\n");
}

std::vector<int> cores() {
  cpu_set_t set;
  std::vector<int> all;
  if (::sched_getaffinity(0, sizeof set, &set) == 0)
    for (int i = 0; i < CPU_SETSIZE; ++i)
      if (CPU_ISSET(i, &set)) all.push_back(i);
  return all.empty() ? std::vector<int>{0} : all;
}

/// What is started while this lives runs on one core: a case then makes no plans for the others.
class OnOneCore {
 public:
  explicit OnOneCore(int core) {
    valid_ = ::sched_getaffinity(0, sizeof before_, &before_) == 0;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(core, &one);
    if (valid_) ::sched_setaffinity(0, sizeof one, &one);
  }
  ~OnOneCore() {
    if (valid_) ::sched_setaffinity(0, sizeof before_, &before_);
  }
  OnOneCore(const OnOneCore&) = delete;
  OnOneCore& operator=(const OnOneCore&) = delete;

 private:
  cpu_set_t before_{};
  bool valid_ = false;
};

struct RunningCase {
  std::size_t index;
  int core;
  ChildProcess child;
};

class Batch {
 public:
  Batch(const std::vector<BatchCase>& cases, const std::vector<std::string>& common, const RunOptions& options)
      : cases_(cases), common_(common), options_(options), folder_(batch_folder(options)), progress_(options.quiet) {
    prepare(folder_, cases, options);
    exit_codes_.assign(cases.size(), 0);
    for (const int core : cores()) free_cores_.insert(core);
  }

  int run() {
    std::size_t next = 0;
    while (next < cases_.size() || !running_.empty()) {
      while (next < cases_.size() && !free_cores_.empty()) start(next++);
      collect();
    }
    return finish();
  }

 private:
  fs::path folder_of(std::size_t index) const { return folder_ / case_name(cases_[index]); }

  void start(std::size_t index) {
    const fs::path folder = folder_of(index);
    if (options_.resume && is_finished(folder)) {
      exit_codes_[index] = stored_exit_code(folder);
      progress_.say(fmt::format("{}: finished before", case_name(cases_[index])));
      return;
    }
    std::vector<std::string> words = {(program_folder() / "validate").string(), "indentation"};
    words.insert(words.end(), common_.begin(), common_.end());
    words.insert(words.end(), cases_[index].words.begin(), cases_[index].words.end());
    words.insert(words.end(), {"--out", folder.string(), "--quiet"});
    if (options_.resume && fs::exists(folder / "work" / "case.json")) words.push_back("--resume");
    if (options_.overwrite && fs::exists(folder)) words.push_back("--overwrite");
    const int core = *free_cores_.begin();
    free_cores_.erase(core);
    const OnOneCore only(core);
    running_.push_back({index, core,
                        ChildProcess({.words = words,
                                      .standard_error = folder_ / (case_name(cases_[index]) + ".log"),
                                      .environment = {{"OMP_NUM_THREADS", "1"}}})});
    progress_.say(fmt::format("{}: started", case_name(cases_[index])));
  }

  void collect() {
    if (running_.empty()) return;
    std::vector<pollfd> descriptors;
    for (const RunningCase& c : running_) descriptors.push_back({c.child.output(), POLLIN, 0});
    ::poll(descriptors.data(), descriptors.size(), 1000);
    if (interrupted()) {
      for (RunningCase& c : running_) c.child.stop();
      throw Error(ExitCode::interrupted,
                  fmt::format("interrupted; continue with --resume --out '{}'", folder_.string()));
    }
    for (RunningCase& c : running_) {
      pollfd one{c.child.output(), POLLIN, 0};
      if (::poll(&one, 1, 0) > 0) c.child.read_lines();  // its table: the numbers are in its summary.json
    }
    running_.remove_if([&](RunningCase& c) {
      if (c.child.output() >= 0) return false;
      const ChildEnd end = c.child.wait();
      exit_codes_[c.index] = end.signal ? 128 + end.signal : end.exit_code;
      free_cores_.insert(c.core);
      progress_.say(fmt::format("{}: ended with exit code {}", case_name(cases_[c.index]), exit_codes_[c.index]));
      return true;
    });
  }

  /// What the verdict in a finished summary.json means.
  static int stored_exit_code(const fs::path& folder) {
    const Json summary = read(folder);
    const auto& agreement = summary.value("agreement", Json(nullptr));
    return agreement.is_object() && !agreement.value("passed", true) ? static_cast<int>(ExitCode::disagreement) : 0;
  }

  static Json read(const fs::path& folder) {
    std::ifstream in(folder / "summary.json");
    return in ? Json::parse(in, nullptr, false) : Json(nullptr);
  }

  int finish() {
    Json document{{"schema", summary_schema}, {"cases", Json::array()}};
    for (std::size_t i = 0; i < cases_.size(); ++i)
      document["cases"].push_back({{"potential", cases_[i].potential},
                                   {"radius_A", cases_[i].radius_A},
                                   {"folder", case_name(cases_[i])},
                                   {"exit_code", exit_codes_[i]},
                                   {"summary", read(folder_of(i))}});
    const std::string text = document.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
    write_file(folder_ / "summary.json", text);
    const bool json_on_stdout = options_.json && *options_.json == "-";
    if (options_.json && !json_on_stdout) write_file(*options_.json, text);
    fmt::print("{}", json_on_stdout ? text : table(document));
    return *std::ranges::max_element(exit_codes_);
  }

  static std::string cell(const Json& value, double factor, const char* format) {
    return value.is_number() ? fmt::format(fmt::runtime(format), factor * value.get<double>()) : "-";
  }

  static std::string table(const Json& document) {
    std::string text =
        fmt::format("{:<14}{:>7}{:>9} {:<7}{:>15}{:>11}{:>12}{:>15}{:>11}  {}\n", "potential", "R", "card", "load",
                    "Eq. 16 E·h", "corrected", "membrane", "pretension", "largest", "verdict");
    text += fmt::format("{:<14}{:>7}{:>9} {:<7}{:>15}{:>11}{:>12}{:>15}{:>11}\n", "", "Å", "N/m", "", "N/m ± error",
                        "N/m", "itself N/m", "N/m ± error", "diff. %");
    for (const Json& entry : document["cases"]) {
      const Json& summary = entry["summary"];
      if (!summary.is_object()) {
        text += fmt::format("{:<14}{:>7g}  failed, exit code {}: see {}.log\n", entry["potential"].get<std::string>(),
                            entry["radius_A"].get<double>(), entry["exit_code"].get<int>(),
                            entry["folder"].get<std::string>());
        continue;
      }
      for (const Json& run : summary["runs"])
        if (run["model"] == "atomistic") text += row(entry, summary, run);
    }
    return text;
  }

  static std::string row(const Json& entry, const Json& summary, const Json& run) {
    const Json null, &agreement = summary["agreement"], &fit = run["fit"];
    const auto of = [&](const Json& object, const char* name) {
      return object.is_object() ? object.value(name, null) : null;
    };
    const bool judged = agreement.is_object() && agreement["load"] == run["load"];
    return fmt::format(
        "{:<14}{:>7}{:>9} {:<7}{:>15}{:>11}{:>12}{:>15}{:>11}  {}\n",
        fs::path(entry["potential"].get<std::string>()).stem().string(), cell(entry["radius_A"], 1, "{:g}"),
        cell(of(summary["card"], "Eh_N_per_m"), 1, "{:.1f}"), run["load"].get<std::string>(),
        cell(of(fit, "Eh_N_per_m"), 1, "{:.1f}") + " ± " + cell(of(fit, "Eh_stderr_N_per_m"), 1, "{:.1f}"),
        cell(of(of(fit, "bias"), "Eh_corrected_N_per_m"), 1, "{:.1f}"),
        cell(of(of(fit, "direct"), "Eh_N_per_m"), 1, "{:.1f}"),
        cell(of(fit, "pretension_N_per_m"), 1, "{:.3f}") + " ± " +
            cell(of(fit, "pretension_stderr_N_per_m"), 1, "{:.3f}"),
        judged ? cell(agreement["max_relative_difference"], 100, "{:.2f}") : "",
        judged ? (agreement["passed"].get<bool>() ? "agreement" : "disagreement") : "");
  }

  const std::vector<BatchCase>& cases_;
  const std::vector<std::string>& common_;
  const RunOptions& options_;
  fs::path folder_;
  Progress progress_;
  std::list<RunningCase> running_;
  std::set<int> free_cores_;
  std::vector<int> exit_codes_;
};

}  // namespace

int run_batch(const std::vector<BatchCase>& cases, const std::vector<std::string>& common, const RunOptions& options) {
  std::set<std::string> names;
  for (const BatchCase& c : cases)
    if (!names.insert(case_name(c)).second) throw bad_input("--potential, --radius: {} is named twice", case_name(c));
  if (options.dry_run) {
    for (const BatchCase& c : cases) fmt::print("{}\n", case_name(c));
    return 0;
  }
  catch_interrupts();
  return Batch(cases, common, options).run();
}

}  // namespace validate
