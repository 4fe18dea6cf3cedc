#include "compare/base/standard_streams.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>

#include "compare/base/system_failure.hpp"

namespace validate {
namespace {

int print_failure = 0;  ///< errno

/// 0, or why not.
int written(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && errno == EAGAIN) {  // whoever shares it has asked not to wait
      pollfd room{descriptor, POLLOUT, 0};
      ::poll(&room, 1, 1000);
      continue;
    }
    if (count < 0) return errno;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

}  // namespace

void prepare_streams() {
  // Lowest number first. Standard output must not look as if it took what it does not: there the way is the wrong one.
  constexpr int ways[] = {O_WRONLY, O_RDONLY, O_WRONLY};
  for (int descriptor = 0; descriptor < 3; ++descriptor)
    if (::fcntl(descriptor, F_GETFD) < 0) ::open("/dev/null", ways[descriptor]);
  for (const int signal : {SIGPIPE, SIGXFSZ}) ::signal(signal, SIG_IGN);
}

void print_result(std::string_view text) {
  if (const int failure = written(STDOUT_FILENO, text)) print_failure = failure;
}

void print_remark(std::string_view text) { written(STDERR_FILENO, text); }

void check_results_printed() {
  if (print_failure != 0) throw system_failure("cannot write to stdout", print_failure);
}

}  // namespace validate
