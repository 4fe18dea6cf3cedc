// Files that are there complete or not at all.
#pragma once

#include <filesystem>
#include <string_view>

namespace validate {

/// A new file beside its target that takes the target's place when committed and is removed when not.
/// Everything that fails throws Error (file failed) naming the target.
class PendingFile {
 public:
  /// Creates an empty file in the target's folder (which must exist).
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
  bool committed_ = false;
};

/// Whether a file of this name is what a killed program has left of a PendingFile for `target`.
bool is_temporary_of(std::string_view name, std::string_view target);

/// Makes the names in it survive a power cut. Some file systems cannot: nothing is lost then.
void sync_folder(const std::filesystem::path& folder);

/// The whole content, atomically.
void write_file(const std::filesystem::path& target, std::string_view content);

}  // namespace validate
