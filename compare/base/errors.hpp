// The one exception for what the user can put right: a clear message and the program's exit code.
// Anything else that escapes (std::exception) is an internal error, exit code 1.
#pragma once

#include <fmt/core.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace validate {

/// Exit codes of `validate`.
enum class ExitCode : int {
  success = 0,  ///< agreement within the tolerance, or nothing to judge
  internal_error = 1,
  bad_input = 2,         ///< usage, case file, potential file
  disagreement = 3,      ///< ran, and differs by more than the tolerance
  not_converged = 4,     ///< a solver stopped before the end of the path
  atomistic_failed = 5,  ///< LAMMPS, its launcher or a rank
  file_failed = 6,       ///< a file that exists cannot be read, or one cannot be written
  interrupted = 130
};

class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ExitCode exit_code() const { return code_; }

 private:
  ExitCode code_;
};

/// `throw bad_input("{}: unknown key '{}'", file, key);`
template <class... Parts>
Error bad_input(fmt::format_string<Parts...> message, Parts&&... parts) {
  return Error(ExitCode::bad_input, fmt::format(message, std::forward<Parts>(parts)...));
}

}  // namespace validate
