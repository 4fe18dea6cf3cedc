#include "compare/process/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "compare/base/errors.hpp"

namespace validate {

FolderLock::FolderLock(const std::filesystem::path& folder)
    : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY)) {  // not close-on-exec: children inherit it
  if (descriptor_ < 0)
    throw Error(ExitCode::file_failed, fmt::format("cannot open '{}': {}", folder.string(), std::strerror(errno)));
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  ::close(descriptor_);
  throw bad_input("--out: '{}' is in use by another run", folder.string());
}

FolderLock::~FolderLock() { ::close(descriptor_); }

}  // namespace validate
