// The folder of one run: who may use it, and whether what it holds is finished.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "compare/input/run_options.hpp"

namespace validate {

/// A locked run folder. While the run is unfinished it has a subfolder `work` with the case, the atomistic program's
/// jobs, logs and finished steps; finish() removes it.
class RunFolder {
 public:
  /// Takes --out, or the first free runs/<default_name>, -2, -3, …; with --resume the newest of these. `identity` is
  /// what decides the numbers, key by key: only a run of the same one is resumed.
  /// Throws Error: bad input for a folder that holds something else, a finished run without --overwrite, an unfinished
  /// one without --resume, or another case; file failed where it cannot be written; bad input where it is in use.
  RunFolder(const RunOptions& options, const std::string& default_name, const nlohmann::ordered_json& identity);
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path work() const { return path_ / "work"; }
  void finish();

  /// Takes away what the constructor made, folders above included, as long as nothing else is in it: a run that failed
  /// before it had computed anything leaves no trace.
  void remove_if_unused();

 private:
  void lock();
  void start(const nlohmann::ordered_json& identity);

  std::filesystem::path path_;
  std::filesystem::path first_new_;  ///< the uppermost folder that did not exist; empty: all did
  bool started_here_ = false;        ///< not resumed
  int lock_ = -1;  ///< inherited by the atomistic program, so that its steps are safe from a second run too
};

}  // namespace validate
