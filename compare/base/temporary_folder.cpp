#include "compare/base/temporary_folder.hpp"

#include <fmt/format.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>
#include <chrono>
#include <fstream>

#include "compare/base/system_failure.hpp"

namespace validate {
namespace {

namespace fs = std::filesystem;

constexpr const char* kept_name = "kept";

bool is_kept(const fs::path& folder) {
  std::error_code error;
  const auto since = fs::last_write_time(folder / kept_name, error);
  return !error && fs::file_time_type::clock::now() - since < std::chrono::hours(24);
}

/// One of ours that is nobody's any more; its lock keeps it so meanwhile.
void remove_if_abandoned(const fs::path& folder) {
  const Descriptor left(folder, O_RDONLY | O_DIRECTORY | O_NOFOLLOW);
  struct stat now {};
  std::error_code ignored;
  if (left.open() && ::fstat(left.get(), &now) == 0 && now.st_uid == ::geteuid() &&
      ::flock(left.get(), LOCK_EX | LOCK_NB) == 0 && !is_kept(folder))
    fs::remove_all(folder, ignored);
}

void remove_abandoned_folders(const fs::path& place, const std::string& start) {
  std::error_code error;
  for (fs::directory_iterator entry(place, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with(start) && name.size() == start.size() + 6) remove_if_abandoned(entry->path());
  }
}

/// Closed in none of the programs that are started: they may write into the folder.
Descriptor locked_folder(const fs::path& folder) {
  Descriptor lock(folder, O_RDONLY | O_DIRECTORY);
  if (lock.open()) ::fcntl(lock.get(), F_SETFD, 0);
  while (lock.open() && ::flock(lock.get(), LOCK_SH) != 0 && errno == EINTR) {
  }
  return lock;
}

}  // namespace

TemporaryFolder::TemporaryFolder(const std::string& prefix) {
  const fs::path place = fs::temp_directory_path();
  remove_abandoned_folders(place, prefix + "-");
  std::error_code error;
  do {  // again where another program has taken it for an abandoned one before it was locked
    std::string name = (place / (prefix + "-XXXXXX")).string();
    if (!::mkdtemp(name.data())) throw system_failure(fmt::format("cannot make the folder '{}'", name), errno);
    path_ = name;
    lock_ = locked_folder(path_);
  } while (!fs::exists(path_, error));
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  if (!kept_) fs::remove_all(path_, ignored);
}

void TemporaryFolder::keep() {
  kept_ = true;
  std::ofstream(path_ / kept_name) << "until tomorrow\n";
}

}  // namespace validate
