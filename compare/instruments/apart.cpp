#include "compare/instruments/apart.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>

#include "compare/base/errors.hpp"

namespace validate {
namespace {

constexpr rlim_t most_seconds = 60;
constexpr char answered = '+', refused = '-';

void write_all(int out, const std::string& text) {
  for (std::size_t from = 0; from < text.size();) {
    const ssize_t written = ::write(out, text.data() + from, text.size() - from);
    if (written < 0 && errno != EINTR) ::_exit(1);
    if (written > 0) from += static_cast<std::size_t>(written);
  }
}

/// Never returns: nothing of the parent's is to be tidied up twice.
[[noreturn]] void work_and_leave(const std::function<std::string()>& work, int out) {
  const int nowhere = ::open("/dev/null", O_WRONLY);
  ::dup2(nowhere, STDERR_FILENO);
  const rlimit none{0, 0}, time{most_seconds, most_seconds};
  ::setrlimit(RLIMIT_CORE, &none);
  ::setrlimit(RLIMIT_CPU, &time);
#ifndef __SANITIZE_ADDRESS__  // whose shadow is larger than any limit
  const rlimit memory{rlim_t{2} << 30, rlim_t{2} << 30};
  ::setrlimit(RLIMIT_AS, &memory);
#endif
  try {
    write_all(out, answered + work());
  } catch (const std::exception& error) {
    write_all(out, refused + std::string(error.what()));
  } catch (...) {
    ::_exit(1);
  }
  ::_exit(0);
}

std::string read_all(int in, std::size_t most_bytes) {
  std::string text;
  std::array<char, 65536> piece;
  while (text.size() <= most_bytes) {
    const ssize_t got = ::read(in, piece.data(), piece.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    text.append(piece.data(), static_cast<std::size_t>(got));
  }
  return text;
}

}  // namespace

std::string done_apart(const std::function<std::string()>& work, std::size_t most_bytes, const std::string& label) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw Error(ExitCode::file_failed, label + ": no pipe can be made");
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child < 0) throw Error(ExitCode::file_failed, label + ": no process can be started");
  if (child == 0) work_and_leave(work, ends[1]);
  ::close(ends[1]);
  std::string answer = read_all(ends[0], most_bytes);
  ::close(ends[0]);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  const bool ended = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  if (!ended || answer.empty() || answer.size() > most_bytes)
    throw bad_input("{}: the file is damaged: its library gives up on it", label);
  if (answer.front() == refused) throw bad_input("{}: {}", label, answer.substr(1));
  return answer.substr(1);
}

}  // namespace validate
