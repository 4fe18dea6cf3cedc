#include "compare/process/run_folder.hpp"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <system_error>
#include <vector>

#include "compare/base/errors.hpp"
#include "compare/base/file.hpp"
#include "compare/base/read_file.hpp"
#include "compare/base/system_failure.hpp"

namespace validate {
namespace {

namespace fs = std::filesystem;

enum class Holds { nothing, begun_run, unfinished_run, finished_run, something_else };

/// Killed between its first folder and its case: nothing but an empty `work`.
bool is_begun(const fs::path& folder) {
  const bool work_alone = !fs::is_empty(folder) &&
                          std::all_of(fs::directory_iterator(folder), fs::directory_iterator(), [](const auto& entry) {
                            return entry.path().filename() == "work" && entry.is_directory();
                          });
  return work_alone &&
         std::all_of(fs::directory_iterator(folder / "work"), fs::directory_iterator(),
                     [](const auto& entry) { return is_temporary_of(entry.path().filename().string(), "case.json"); });
}

Holds contents(const fs::path& folder) {
  if (!fs::exists(folder)) return Holds::nothing;
  if (!fs::is_directory(folder)) return Holds::something_else;
  const auto record = read_record(folder);
  if (record && record->exit_code) return Holds::finished_run;
  if (is_resumable(folder)) return Holds::unfinished_run;
  if (record) return record->folders.empty() ? Holds::begun_run : Holds::something_else;
  if (fs::exists(folder / "summary.json")) return Holds::finished_run;  // by a version that kept no record
  if (is_begun(folder)) return Holds::begun_run;
  return fs::is_empty(folder) ? Holds::begun_run : Holds::something_else;  // killed before its first folder
}

fs::path numbered(const std::string& name, int number) {
  return fs::path("runs") / (number == 1 ? name : fmt::format("{}-{}", name, number));
}

/// The last default folder that exists.
fs::path last_default_folder(const std::string& name) {
  int number = 1;
  while (fs::exists(numbered(name, number))) ++number;
  if (number == 1)
    throw bad_input("--resume: there is no run in '{}'; name its folder with --out", numbered(name, 1).string());
  return numbered(name, number - 1);
}

/// The uppermost folder of a path that does not exist; empty: all do.
fs::path uppermost_new(const fs::path& path) {
  fs::path first_new;
  std::error_code error;
  for (fs::path above = path; !fs::exists(above, error) && above.has_relative_path(); above = above.parent_path())
    first_new = above;
  return first_new;
}

/// What is in the folder, where the options allow it.
Holds allowed_contents(const fs::path& folder, const RunOptions& options) {
  const Holds holds = contents(folder);
  switch (holds) {
    case Holds::something_else:
      throw bad_input("--out: '{}' exists and does not hold a run of this program; choose another folder",
                      folder.string());
    case Holds::finished_run:
      if (!options.overwrite)
        throw bad_input("--out: '{}' holds a finished run; --overwrite replaces it", folder.string());
      break;
    case Holds::unfinished_run:
      if (!options.overwrite && !options.resume)
        throw bad_input("--out: '{}' holds an unfinished run; --resume continues it, --overwrite starts again",
                        folder.string());
      break;
    case Holds::nothing:
      if (options.resume) throw bad_input("--resume: '{}' holds no unfinished run", folder.string());
      break;
    case Holds::begun_run:
      break;  // before its case was kept: whatever is asked for, it starts
  }
  return holds;
}

/// A path in it need not be UTF-8: its foreign bytes become replacement characters.
std::string text_of(const nlohmann::ordered_json& identity) {
  return identity.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void refuse_changed_case(const fs::path& saved, const nlohmann::ordered_json& identity) {
  const auto now = nlohmann::ordered_json::parse(text_of(identity));
  const auto before = nlohmann::ordered_json::parse(read_if_there(saved).value_or(""), nullptr, false);
  std::string changed;
  for (const auto& [key, value] : now.items())
    if (!before.is_object() || !before.contains(key) || before[key] != value)
      changed += (changed.empty() ? "" : ", ") + key;
  if (!changed.empty()) throw bad_input("--resume: the case has changed ({}); run it into a new folder", changed);
}

}  // namespace

NewFolder make_numbered_folder(const std::function<fs::path(int number)>& numbered) {
  for (int number = 1;; ++number) {
    const fs::path path = fs::absolute(numbered(number)), first_new = uppermost_new(path);
    std::error_code error;
    if (first_new.empty()) continue;
    fs::create_directories(path.parent_path(), error);
    if (!error && fs::create_directory(path, error)) return {path, first_new};
    if (error) throw system_failure(fmt::format("cannot create '{}'", path.string()), error.value());
  }
}

RunFolder::RunFolder(const RunOptions& options, const std::string& default_name, const nlohmann::ordered_json& identity)
    : DocumentFolder("work") {
  if (options.out || options.resume) {
    path_ = fs::absolute(options.out ? *options.out : last_default_folder(default_name)).lexically_normal();
    if (!path_.has_filename()) path_ = path_.parent_path();  // a slash at the end
    allowed_contents(path_, options);                        // before anything is made
    first_new_ = uppermost_new(path_);
  } else {
    const NewFolder made = make_numbered_folder([&](int number) { return numbered(default_name, number); });
    path_ = made.path;
    first_new_ = made.first_new;
  }
  std::error_code error;
  fs::create_directories(path_, error);
  if (error) throw system_failure(fmt::format("cannot create '{}'", path_.string()), error.value());
  lock_.emplace(path_, options.resume ? 5 : 0);
  const Holds holds = allowed_contents(path_, options);  // another run may have been here until now
  if (options.resume && holds == Holds::unfinished_run) {
    refuse_changed_case(work() / "case.json", identity);
    record_ = read_record(path_).value_or(RunRecord());
    fs::remove_all(work() / "drafts", error);  // half written ones
  } else {
    start(identity);
  }
}

void RunFolder::start(const nlohmann::ordered_json& identity) {
  clear_run(path_);
  std::error_code error;
  fs::create_directories(work(), error);
  if (error) throw system_failure(fmt::format("cannot write in '{}'", path_.string()), error.value());
  write_file(work() / "case.json", text_of(identity));
  started_here_ = true;
}

void RunFolder::finish(ExitCode code) {
  publish();
  record_.exit_code = static_cast<int>(code);
  write_record(path_, record_);
  std::error_code ignored;
  fs::remove_all(work(), ignored);
}

void RunFolder::remove_if_unused() {
  std::error_code ignored;
  const auto entries = [&](const fs::path& folder) {
    return std::distance(fs::directory_iterator(folder, ignored), {});
  };
  if (!started_here_ || entries(work()) > 1 || entries(path_) > 1) return;
  fs::remove_all(work(), ignored);
  if (first_new_.empty()) return;
  for (fs::path folder = path_; fs::remove(folder, ignored) && folder != first_new_;) folder = folder.parent_path();
}

std::optional<int> finished_exit_code(const fs::path& folder) {
  const auto record = read_record(folder);
  return record ? record->exit_code : std::nullopt;
}

bool is_resumable(const fs::path& folder) {
  return !finished_exit_code(folder) && fs::exists(folder / "work" / "case.json");
}

}  // namespace validate
