// Folders that the program writes documents into, with a record of their names.
#pragma once

#include <filesystem>
#include <optional>

#include "compare/process/folder_lock.hpp"
#include "compare/process/run_record.hpp"

namespace validate {

/// A locked folder. Documents are written into drafts() and moved up by publish(), which first puts their names into
/// the folder's record: whatever the program has left in the folder, and wherever it was killed, --overwrite knows it
/// from what the user has put there.
class DocumentFolder {
 public:
  DocumentFolder(const DocumentFolder&) = delete;
  DocumentFolder& operator=(const DocumentFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// Holds what is not to stay; there once drafts() has been called.
  std::filesystem::path work() const { return path_ / work_name_; }

  /// Where documents are written: on the folder's file system, made if it is not there.
  std::filesystem::path drafts() const;

  /// Moves every file of drafts() into the folder. One that cannot be moved does not keep the others from it; the first
  /// failure is thrown at the end (Error, file failed).
  void publish();

 protected:
  explicit DocumentFolder(const char* work_name) : work_name_(work_name) {}
  ~DocumentFolder() = default;

  std::filesystem::path path_;
  const char* work_name_;
  std::optional<FolderLock> lock_;
  RunRecord record_;
};

/// The folder of a command that is no run: it may be called into one folder again and again, and what it writes stands
/// beside what is there.
class OutputFolder : public DocumentFolder {
 public:
  /// Takes `out`, made if it is not there, with drafts(). With `overwrite` what the program has written there before
  /// goes first.
  /// Throws Error: bad input for an unfinished run's folder and for one in use; file failed where it cannot be written.
  OutputFolder(const std::filesystem::path& out, bool overwrite);

  /// Publishes, and keeps the exit code where no run has left its own.
  void finish(int exit_code);

 private:
  bool of_a_run_ = false;  ///< the record has an exit code that is not ours
};

}  // namespace validate
