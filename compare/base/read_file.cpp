#include "compare/base/read_file.hpp"

#include <poll.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstddef>
#include <system_error>

#include "compare/base/descriptor.hpp"
#include "compare/base/interrupt.hpp"
#include "compare/base/system_failure.hpp"

namespace validate {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_bytes = std::size_t{1} << 30;

/// 0, or the errno of what went wrong. A FIFO gives what its writers have put into it, and is at its end without one.
int read_all(const Descriptor& file, std::string& content) {
  char buffer[65536];
  struct stat now {};
  if (::fstat(file.get(), &now) == 0 && now.st_size > static_cast<off_t>(most_bytes)) return EFBIG;
  for (;;) {
    const ssize_t got = ::read(file.get(), buffer, sizeof buffer);
    if (got == 0) return 0;
    if (got > 0) content.append(buffer, static_cast<std::size_t>(got));
    if (content.size() > most_bytes) return EFBIG;
    if (got > 0) continue;
    if (errno != EAGAIN && errno != EINTR) return errno;
    if (interrupted()) return EINTR;
    pollfd wait_for{file.get(), POLLIN, 0};
    if (errno == EAGAIN) ::poll(&wait_for, 1, 1000);
  }
}

}  // namespace

std::string read_file(const fs::path& file, std::string_view label) {
  const std::string start = label.empty() ? std::string{} : fmt::format("{}: ", label);
  const auto cannot_read = [&](int error) {
    return system_failure(fmt::format("{}cannot read '{}'", start, file.string()), error);
  };
  std::error_code problem;
  const fs::file_type kind = fs::status(file, problem).type();
  if (kind == fs::file_type::not_found) throw bad_input("{}there is no file '{}'", start, file.string());
  if (kind == fs::file_type::none) throw cannot_read(problem.value());
  if (kind == fs::file_type::directory) throw bad_input("{}'{}' is a folder, not a file", start, file.string());
  if (kind != fs::file_type::regular && kind != fs::file_type::fifo)
    throw bad_input("{}'{}' is a device or a socket, not a file", start, file.string());
  const Descriptor open(file, O_RDONLY | O_NONBLOCK);
  if (!open.open()) throw cannot_read(errno);
  std::string content;
  if (const int error = read_all(open, content)) throw cannot_read(error);
  return content;
}

std::optional<std::string> read_if_there(const fs::path& file) {
  std::error_code problem;
  if (!fs::is_regular_file(file, problem)) return std::nullopt;
  const Descriptor open(file, O_RDONLY | O_NONBLOCK);
  std::string content;
  if (!open.open() || read_all(open, content) != 0) return std::nullopt;
  return content;
}

}  // namespace validate
