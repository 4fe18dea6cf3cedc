#include "compare/process/run_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>
#include <vector>

#include "compare/base/errors.hpp"
#include "compare/base/file.hpp"

namespace validate {
namespace {

namespace fs = std::filesystem;

/// What a run leaves in its folder, and so may be replaced by the next one; anything else there is the user's.
bool is_run_file(const std::string& name) {
  constexpr std::string_view names[] = {
      "run.h5",          "curves.csv",      "summary.json", "figure.svg", "figure.png",
      "window_scan.svg", "window_scan.png", "report.html",  "lammps.log", "work"};
  return std::find(std::begin(names), std::end(names), name) != std::end(names) ||
         (name.starts_with("atoms-") && (name.ends_with(".extxyz") || name.ends_with(".data"))) ||
         name.starts_with("switched-");
}

enum class Holds { nothing, finished_run, unfinished_run, something_else };

Holds contents(const fs::path& folder) {
  if (!fs::exists(folder)) return Holds::nothing;
  if (!fs::is_directory(folder)) return Holds::something_else;
  if (fs::exists(folder / "work" / "case.json")) return Holds::unfinished_run;
  if (fs::exists(folder / "summary.json")) return Holds::finished_run;
  return fs::is_empty(folder) ? Holds::nothing : Holds::something_else;
}

fs::path numbered(const std::string& name, int number) {
  return fs::path("runs") / (number == 1 ? name : fmt::format("{}-{}", name, number));
}

/// The first free default folder, or with --resume the last one that exists.
fs::path default_folder(const std::string& name, bool resume) {
  int number = 1;
  while (fs::exists(numbered(name, number))) ++number;
  if (!resume) return numbered(name, number);
  if (number == 1)
    throw bad_input("--resume: there is no run in '{}'; name its folder with --out", numbered(name, 1).string());
  return numbered(name, number - 1);
}

void refuse_contents(const fs::path& folder, const RunOptions& options) {
  switch (contents(folder)) {
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
  }
}

void refuse_changed_case(const fs::path& saved, const nlohmann::ordered_json& now) {
  std::ifstream in(saved);
  const auto before = nlohmann::ordered_json::parse(in, nullptr, false);
  std::string changed;
  for (const auto& [key, value] : now.items())
    if (!before.is_object() || !before.contains(key) || before[key] != value)
      changed += (changed.empty() ? "" : ", ") + key;
  if (!changed.empty()) throw bad_input("--resume: the case has changed ({}); run it into a new folder", changed);
}

}  // namespace

RunFolder::RunFolder(const RunOptions& options, const std::string& default_name,
                     const nlohmann::ordered_json& identity) {
  path_ = fs::absolute(options.out ? *options.out : default_folder(default_name, options.resume)).lexically_normal();
  if (!path_.has_filename()) path_ = path_.parent_path();  // a slash at the end
  refuse_contents(path_, options);
  std::error_code error;
  for (fs::path above = path_; !fs::exists(above, error) && above.has_relative_path(); above = above.parent_path())
    first_new_ = above;
  fs::create_directories(path_, error);
  if (error) throw Error(ExitCode::file_failed, fmt::format("cannot create '{}': {}", path_.string(), error.message()));
  lock();
  if (options.resume) {
    refuse_changed_case(work() / "case.json", identity);
  } else {
    start(identity);
  }
}

RunFolder::~RunFolder() {
  if (lock_ >= 0) ::close(lock_);
}

void RunFolder::lock() {
  // Not close-on-exec: the atomistic program holds the lock for as long as it may still write.
  lock_ = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY);
  if (lock_ < 0)
    throw Error(ExitCode::file_failed, fmt::format("cannot open '{}': {}", path_.string(), std::strerror(errno)));
  if (::flock(lock_, LOCK_EX | LOCK_NB) != 0) throw bad_input("--out: '{}' is in use by another run", path_.string());
}

void RunFolder::start(const nlohmann::ordered_json& identity) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(path_))
    if (is_run_file(entry.path().filename().string())) fs::remove_all(entry.path(), error);
  if (!error) fs::create_directories(work(), error);
  if (error)
    throw Error(ExitCode::file_failed, fmt::format("cannot write in '{}': {}", path_.string(), error.message()));
  write_file(work() / "case.json", identity.dump(1) + "\n");
  started_here_ = true;
}

void RunFolder::remove_if_unused() {
  std::error_code ignored;
  const auto entries = [](const fs::path& folder) { return std::distance(fs::directory_iterator(folder), {}); };
  if (!started_here_ || entries(work()) > 1 || entries(path_) > 1) return;
  fs::remove_all(work(), ignored);
  if (first_new_.empty()) return;
  for (fs::path folder = path_; fs::remove(folder, ignored) && folder != first_new_;) folder = folder.parent_path();
}

void RunFolder::finish() {
  std::error_code ignored;
  fs::remove_all(work(), ignored);
}

}  // namespace validate
