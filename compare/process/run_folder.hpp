// The folder of one run: who may use it, and whether what it holds is finished.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "compare/base/errors.hpp"
#include "compare/input/run_options.hpp"
#include "compare/process/document_folder.hpp"

namespace validate {

/// While the run is unfinished its folder has a subfolder `work` with the case, the atomistic program's jobs, logs and
/// finished steps; finish() removes it.
class RunFolder : public DocumentFolder {
 public:
  /// Takes --out, or the first free runs/<default_name>, -2, -3, …; with --resume the newest of these. `identity` is
  /// what decides the numbers, key by key: only a run of the same one is resumed.
  /// Throws Error: bad input for a folder that holds something else, a finished run without --overwrite, an unfinished
  /// one without --resume, or another case; file failed where it cannot be written; bad input where it is in use.
  RunFolder(const RunOptions& options, const std::string& default_name, const nlohmann::ordered_json& identity);

  /// Publishes, keeps the exit code, removes `work`.
  void finish(ExitCode code);

  /// Takes away what the constructor made, folders above included, as long as nothing else is in it: a run that failed
  /// before it had computed anything leaves no trace.
  void remove_if_unused();

 private:
  void start(const nlohmann::ordered_json& identity);

  std::filesystem::path first_new_;  ///< the uppermost folder that did not exist; empty: all did
  bool started_here_ = false;        ///< not resumed
};

struct NewFolder {
  std::filesystem::path path;
  std::filesystem::path first_new;  ///< the uppermost folder that was made for it
};

/// Makes the first of these folders that is not there yet: of several programs that ask at once each gets its own.
/// Throws Error (file failed).
NewFolder make_numbered_folder(const std::function<std::filesystem::path(int number)>& numbered);

/// The exit code of the finished run in a folder; nothing where there is none.
std::optional<int> finished_exit_code(const std::filesystem::path& folder);

/// Whether the folder holds a run that --resume continues.
bool is_resumable(const std::filesystem::path& folder);

}  // namespace validate
