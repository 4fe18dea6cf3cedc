#include "compare/base/file.hpp"

#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <string>

#include "compare/base/system_failure.hpp"

namespace validate {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view temporary_end = ".tmp";

Error cannot_write(const fs::path& target, int error) {
  return system_failure(fmt::format("cannot write '{}'", target.string()), error);
}

/// Named after its target, as far as a name may go, so that a left-over one explains itself.
std::string temporary_start(std::string_view target) {
  constexpr std::size_t longest = 200;
  return fmt::format(".{}.", target.substr(0, longest));
}

/// Process and count keep programs out of each other's way; where process ids repeat the next count is taken.
fs::path next_temporary(const fs::path& target) {
  static std::atomic<int> count{0};
  return target.parent_path() /
         fmt::format("{}{}-{}{}", temporary_start(target.filename().string()), ::getpid(), count++, temporary_end);
}

/// Held until the descriptor is closed, by a kill too. False: the file was taken for an abandoned one before that.
/// Where a file system has no locks nothing is ever taken for abandoned.
bool locked(const Descriptor& file) {
  struct stat now {};
  while (::flock(file.get(), LOCK_EX) != 0 && errno == EINTR) {
  }
  return ::fstat(file.get(), &now) == 0 && now.st_nlink > 0;
}

void remove_abandoned(const fs::path& target) {
  const std::string name = target.filename().string();
  std::error_code error;
  for (fs::directory_iterator entry(target.parent_path(), error), end; !error && entry != end; entry.increment(error)) {
    if (!is_temporary_of(entry->path().filename().string(), name)) continue;
    const Descriptor left(entry->path(), O_RDWR | O_NOFOLLOW | O_NONBLOCK);
    if (left.open() && ::flock(left.get(), LOCK_EX | LOCK_NB) == 0) ::unlink(entry->path().c_str());
  }
}

void write_all(const Descriptor& file, std::string_view content, const fs::path& target) {
  while (!content.empty()) {
    const ssize_t written = ::write(file.get(), content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw cannot_write(target, errno);
    content.remove_prefix(static_cast<std::size_t>(written));
  }
}

/// Where the user's name leads.
struct Place {
  fs::path path;         ///< no link any more
  bool through = false;  ///< to be written into as it is
};

Place place_of(const fs::path& target) {
  constexpr int most_links = 40;
  Place place{fs::absolute(target)};
  std::error_code error;
  for (int i = 0; fs::is_symlink(fs::symlink_status(place.path, error)); ++i) {
    if (i == most_links) throw cannot_write(target, ELOOP);
    if (place.path.string().starts_with("/proc/")) return {target, true};  // an open file, whatever its name was
    const fs::path next = fs::read_symlink(place.path, error);
    if (error) throw cannot_write(target, error.value());
    place.path = next.is_absolute() ? next : place.path.parent_path() / next;
  }
  const fs::file_type kind = fs::status(place.path, error).type();
  if (kind == fs::file_type::directory) throw cannot_write(target, EISDIR);
  place.through = kind != fs::file_type::regular && kind != fs::file_type::not_found && kind != fs::file_type::none;
  return place;
}

}  // namespace

bool is_temporary_of(std::string_view name, std::string_view target) {
  const std::string start = temporary_start(target);
  if (!name.starts_with(start) || !name.ends_with(temporary_end)) return false;
  const std::string_view numbers = name.substr(start.size(), name.size() - start.size() - temporary_end.size());
  return !numbers.empty() && numbers.find_first_not_of("0123456789-") == std::string_view::npos;
}

PendingFile::PendingFile(fs::path target) : target_(fs::absolute(std::move(target))) {
  std::error_code error;  // the temporary's name is shorter
  if (!fs::exists(target_, error) && error == std::errc::filename_too_long) throw cannot_write(target_, error.value());
  remove_abandoned(target_);
  while (!lock_.open()) {
    path_ = next_temporary(target_);
    Descriptor created(path_, O_WRONLY | O_CREAT | O_EXCL);
    if (!created.open() && errno != EEXIST) throw cannot_write(target_, errno);
    if (created.open() && locked(created)) lock_ = std::move(created);
  }
}

PendingFile::~PendingFile() {
  if (!committed_) ::unlink(path_.c_str());
}

void PendingFile::write(std::string_view content) {
  const Descriptor file(path_, O_WRONLY | O_TRUNC);
  if (!file.open()) throw cannot_write(target_, errno);
  write_all(file, content, target_);
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

void write_users_file(const fs::path& target, std::string_view content) {
  const Place place = place_of(target);
  if (place.through) {
    const Descriptor file(place.path, O_WRONLY | O_APPEND);
    if (!file.open()) throw cannot_write(target, errno);
    return write_all(file, content, target);
  }
  PendingFile file(place.path);
  file.write(content);
  struct stat before {};
  if (::stat(place.path.c_str(), &before) == 0) ::chmod(file.path().c_str(), before.st_mode & 07777);
  file.commit();
}

void check_users_file(const fs::path& target) {
  const Place place = place_of(target);
  if (!place.through)
    const PendingFile removed_again(place.path);
  else if (::access(place.path.c_str(), W_OK) != 0)
    throw cannot_write(target, errno);
}

}  // namespace validate
