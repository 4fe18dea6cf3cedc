// A program started without a shell, its standard output read as lines, its standard error kept in a file.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace validate {

struct ChildCommand {
  std::vector<std::string> words;        ///< program (searched in PATH) and arguments
  std::filesystem::path folder;          ///< where it runs
  std::filesystem::path standard_error;  ///< file
};

/// How a child ended.
struct ChildEnd {
  int exit_code = 0;  ///< if no signal
  int signal = 0;     ///< 0: none
  bool good() const { return exit_code == 0 && signal == 0; }
};

/// Runs in a process group of its own, dies with this program (even by kill -9), reads nothing from stdin.
class ChildProcess {
 public:
  /// Throws Error (atomistic failed) naming the program if it cannot be started.
  explicit ChildProcess(const ChildCommand& command);
  ~ChildProcess();  ///< stops it if it still runs
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;

  int output() const { return output_; }  ///< descriptor to poll for reading; −1 once it has ended

  /// Complete lines that have arrived; call when output() is readable. Closes output() at its end.
  std::vector<std::string> read_lines();

  /// Asks the whole group to stop, then insists. Returns when it has ended.
  ChildEnd stop();
  ChildEnd wait();

 private:
  pid_t pid_ = -1;
  int output_ = -1;
  std::string unfinished_line_;
  std::optional<ChildEnd> end_;
};

/// The program's file as PATH finds it, or nothing.
std::optional<std::filesystem::path> find_program(const std::string& name);

}  // namespace validate
