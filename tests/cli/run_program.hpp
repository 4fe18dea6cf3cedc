// Starts the program `validate` the way a shell does, without a shell.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace cli_tests {

struct Outcome {
  int exit_code = -1;  ///< −1 if it was ended by a signal
  std::string out, err;
  double cpu_ms = 0;  ///< of the program itself and the children it waited for; other programs' load does not count
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
  pid_t child_ = -1;
};

/// Runs `validate` with these words in this folder; `environment` holds NAME=value entries added to the own
/// one.
Outcome run_validate(const std::vector<std::string>& words, const std::filesystem::path& folder,
                     const std::vector<std::string>& environment = {});

}  // namespace cli_tests
