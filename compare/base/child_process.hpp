// A program started without a shell, its standard output read as lines or as a whole.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compare/base/errors.hpp"

namespace validate {

struct ChildCommand {
  std::vector<std::string> words;                                     ///< program (searched in PATH) and arguments
  std::filesystem::path folder = {};                                  ///< where it runs; empty: where this program does
  std::filesystem::path standard_error = {};                          ///< file; empty: mixed into the standard output
  std::vector<std::pair<std::string, std::string>> environment = {};  ///< variables that the user has not set
  ExitCode if_not_started = ExitCode::atomistic_failed;               ///< of the error
  bool holds_locks = true;  ///< keeps others out of this program's folders until it has ended
};

/// How a child ended.
struct ChildEnd {
  int exit_code = 0;  ///< if no signal
  int signal = 0;     ///< 0: none
  bool good() const { return exit_code == 0 && signal == 0; }
};

/// Runs in a process group of its own, dies with the thread that started it (even by kill -9), reads nothing from
/// stdin.
class ChildProcess {
 public:
  /// Throws Error (the command's exit code) naming the program if it cannot be started; file failed where its standard
  /// error cannot be kept.
  explicit ChildProcess(const ChildCommand& command);
  ~ChildProcess();  ///< stops it if it still runs
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;

  int output() const { return output_; }  ///< descriptor to poll for reading; −1 once it has ended

  /// Complete lines that have arrived; call when output() is readable. Closes output() at its end.
  std::vector<std::string> read_lines();

  /// All that it writes until its end, an unfinished last line included. Throws Error (interrupted) after stopping it
  /// when a signal has come.
  std::string read_to_end();

  void ask_to_stop();

  /// Asks the whole group to stop, then insists. Returns when it has ended.
  ChildEnd stop();
  ChildEnd wait();

 private:
  bool read_more();  ///< what has arrived goes to unread_; false at its end

  pid_t pid_ = -1;
  int output_ = -1;
  std::string unread_;
  std::optional<ChildEnd> end_;
};

/// The program's file as PATH finds it, or nothing.
std::optional<std::filesystem::path> find_program(const std::string& name);

}  // namespace validate
