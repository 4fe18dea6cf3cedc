// Files that are there complete or not at all.
#pragma once

#include <filesystem>
#include <string_view>

#include "compare/base/descriptor.hpp"

namespace validate {

/// A new file beside its target that takes the target's place when committed and is removed when not. What is in that
/// place (a link, a FIFO) is replaced, never written through: the name is the program's own.
/// Everything that fails throws Error (file failed; bad input for a name that is too long) naming the target.
class PendingFile {
 public:
  /// Creates an empty file in the target's folder (which must exist), and removes what killed programs have left of
  /// others for this target.
  explicit PendingFile(std::filesystem::path target);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  /// Where to write until commit(): absolute, for programs and libraries that open files by name.
  const std::filesystem::path& path() const { return path_; }

  void write(std::string_view content);

  /// Flushes to the disk (file and folder) and renames to the target.
  void commit();

 private:
  std::filesystem::path target_, path_;
  Descriptor lock_;  ///< tells other programs that this one still writes
  bool committed_ = false;
};

/// Whether a file of this name is what a killed program has left of a PendingFile for `target`.
bool is_temporary_of(std::string_view name, std::string_view target);

/// Makes the names in it survive a power cut. Some file systems cannot: nothing is lost then.
void sync_folder(const std::filesystem::path& folder);

/// The whole content, atomically, under a name of the program's own: see PendingFile.
void write_file(const std::filesystem::path& target, std::string_view content);

/// The same where the user has said to. A link is followed, a file keeps its permissions; a device, a FIFO or a socket
/// is written into, and so is what /proc stands for: none of them is replaced.
void write_users_file(const std::filesystem::path& target, std::string_view content);

/// Throws what write_users_file() would, as far as that can be known before; leaves everything as it is.
void check_users_file(const std::filesystem::path& target);

}  // namespace validate
