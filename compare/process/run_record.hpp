// What the program itself has put into a folder, and how the run there ended: the file .validate-run in it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace validate {

/// Names are those of entries of the folder, never paths: a record may come from others, and what it names is removed
/// by --overwrite.
struct RunRecord {
  std::vector<std::string> files;    ///< written there by the program, or about to be
  std::vector<std::string> folders;  ///< below it, each with a run of its own (a batch)
  std::optional<int> exit_code;      ///< of a finished run

  void add_file(const std::string& name);    ///< once
  void add_folder(const std::string& name);  ///< once
};

/// Nothing where the folder has none that can be read.
std::optional<RunRecord> read_record(const std::filesystem::path& folder);

/// Replaces the folder's record. Throws Error (file failed).
void write_record(const std::filesystem::path& folder, const RunRecord& record);

/// Notes a file that is about to be written later than its run, where its folder keeps a record. Throws Error (file
/// failed).
void add_to_record(const std::filesystem::path& file);

/// Removes what the folder's record names, the runs below it included, and `work`, which no run lets anything else
/// into. What else is there is the user's and stays, with an empty record beside it. A kill on the way leaves
/// everything that is still there in the record. Throws Error (file failed).
void clear_run(const std::filesystem::path& folder);

/// The same of a folder that is no run's: a `work` in it is the user's.
void clear_documents(const std::filesystem::path& folder);

}  // namespace validate
