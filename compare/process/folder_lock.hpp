// One writer a folder.
#pragma once

#include <filesystem>

namespace validate {

/// Held until the end, and by every program started meanwhile until its own: what may still write keeps others out.
class FolderLock {
 public:
  /// Throws Error: bad input where another run has the folder, file failed where it cannot be opened.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace validate
