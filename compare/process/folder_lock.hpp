// One writer a folder.
#pragma once

#include <filesystem>

namespace validate {

/// Held until the end, and by every program started meanwhile until its own: what may still write keeps others out.
class FolderLock {
 public:
  /// Waits up to `patience_s` for what still holds the folder: the ranks of a run that was killed take their time.
  /// Throws Error: bad input where another run has the folder, file failed where it cannot be opened.
  explicit FolderLock(const std::filesystem::path& folder, double patience_s = 0);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// Throws Error (file failed) where the folder has been removed or renamed: what is there now may be another run's.
  void require_in_place() const;

 private:
  std::filesystem::path folder_;
  int descriptor_;
};

}  // namespace validate
