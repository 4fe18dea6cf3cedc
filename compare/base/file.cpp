#include "compare/base/file.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <string>

#include "compare/base/errors.hpp"

namespace validate {

namespace fs = std::filesystem;

namespace {

Error cannot_write(const fs::path& target, int error) {
  return Error(ExitCode::file_failed, fmt::format("cannot write '{}': {}", target.string(), std::strerror(error)));
}

class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags) : fd_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  bool open() const { return fd_ >= 0; }
  int get() const { return fd_; }

 private:
  int fd_;
};

// Named after its target so that a left-over one explains itself; process and count make it unique.
fs::path temporary_beside(const fs::path& target) {
  static std::atomic<int> count{0};
  return target.parent_path() / fmt::format(".{}.{}-{}.tmp", target.filename().string(), ::getpid(), count++);
}

}  // namespace

bool is_temporary_of(std::string_view name, std::string_view target) {
  return name.starts_with(fmt::format(".{}.", target)) && name.ends_with(".tmp");
}

PendingFile::PendingFile(fs::path target) : target_(fs::absolute(std::move(target))), path_(temporary_beside(target_)) {
  const Descriptor created(path_, O_WRONLY | O_CREAT | O_EXCL);
  if (!created.open()) throw cannot_write(target_, errno);
}

PendingFile::~PendingFile() {
  if (!committed_) ::unlink(path_.c_str());
}

void PendingFile::write(std::string_view content) {
  const Descriptor file(path_, O_WRONLY | O_TRUNC);
  if (!file.open()) throw cannot_write(target_, errno);
  while (!content.empty()) {
    const ssize_t written = ::write(file.get(), content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw cannot_write(target_, errno);
    content.remove_prefix(static_cast<std::size_t>(written));
  }
}

void PendingFile::commit() {
  const Descriptor file(path_, O_RDONLY);
  if (!file.open() || ::fsync(file.get()) != 0) throw cannot_write(target_, errno);
  if (::rename(path_.c_str(), target_.c_str()) != 0) throw cannot_write(target_, errno);
  committed_ = true;
  sync_folder(target_.parent_path());
}

void sync_folder(const fs::path& path) {
  const Descriptor folder(path, O_RDONLY | O_DIRECTORY);
  if (folder.open()) ::fsync(folder.get());
}

void write_file(const fs::path& target, std::string_view content) {
  PendingFile file(target);
  file.write(content);
  file.commit();
}

}  // namespace validate
