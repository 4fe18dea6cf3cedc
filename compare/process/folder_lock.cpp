#include "compare/process/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <thread>

#include "compare/base/system_failure.hpp"

namespace validate {

FolderLock::FolderLock(const std::filesystem::path& folder, double patience_s)
    : folder_(folder),
      descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY)) {  // not close-on-exec: children inherit it
  if (descriptor_ < 0) throw system_failure(fmt::format("cannot open '{}'", folder.string()), errno);
  constexpr int tries_per_s = 20;
  for (int left = static_cast<int>(patience_s * tries_per_s); left >= 0; --left) {
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
    if (left > 0) std::this_thread::sleep_for(std::chrono::milliseconds(1000 / tries_per_s));
  }
  ::close(descriptor_);
  throw bad_input("--out: '{}' is in use by another run", folder.string());
}

void FolderLock::require_in_place() const {
  struct stat ours {
  }, there{};
  if (::fstat(descriptor_, &ours) == 0 && ::stat(folder_.c_str(), &there) == 0 && ours.st_ino == there.st_ino &&
      ours.st_dev == there.st_dev)
    return;
  throw Error(ExitCode::file_failed, fmt::format("the folder '{}' has been taken away", folder_.string()));
}

FolderLock::~FolderLock() { ::close(descriptor_); }

}  // namespace validate
