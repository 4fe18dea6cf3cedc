// Starts the program `validate` the way a shell does, without a shell.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace cli_tests {

struct Outcome {
  int exit_code = -1;  ///< −1 if it was ended by a signal
  std::string out, err;
  double wall_ms = 0;
};

/// A new folder that is removed at the end.
class WorkFolder {
 public:
  WorkFolder();
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }
  void write(const std::string& name, const std::string& content) const;

 private:
  std::filesystem::path path_;
};

/// `validate` while it runs.
class RunningValidate {
 public:
  RunningValidate(const std::vector<std::string>& words, const std::filesystem::path& folder,
                  const std::vector<std::string>& environment = {});
  pid_t pid() const { return child_; }
  Outcome wait();

 private:
  WorkFolder streams_;  // not in `folder`, which must show only what the program leaves
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  pid_t child_ = -1;
};

/// Runs `validate` with these words in this folder; `environment` holds NAME=value entries added to the own
/// one.
Outcome run_validate(const std::vector<std::string>& words, const std::filesystem::path& folder,
                     const std::vector<std::string>& environment = {});

}  // namespace cli_tests
