#include "compare/base/child_process.hpp"

#include <fcntl.h>
#include <linux/close_range.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <thread>
#include <utility>

#include "compare/base/interrupt.hpp"
#include "compare/base/system_failure.hpp"

extern char** environ;

namespace validate {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> all_variables(const std::vector<std::pair<std::string, std::string>>& defaults) {
  std::vector<std::string> all;
  for (char** variable = environ; *variable; ++variable) all.emplace_back(*variable);
  for (const auto& [name, value] : defaults)
    if (!std::getenv(name.c_str())) all.push_back(name + "=" + value);
  return all;
}

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> all;
  for (std::string& word : words) all.push_back(word.data());
  all.push_back(nullptr);
  return all;
}

struct Pipe {
  int read = -1, write = -1;
  Pipe() {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) throw system_failure("no pipe", errno);
    read = ends[0];
    write = ends[1];
  }
};

/// In the new process, between fork and exec: only calls that are safe there.
[[noreturn]] void become(const char* program, char** arguments, char** variables, const char* folder, int error_file,
                         int output, int report, pid_t parent, bool holds_locks) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);  // mpiexec takes its ranks along
  if (::getppid() != parent) ::_exit(127);
  const int nothing = ::open("/dev/null", O_RDONLY);
  const bool ready = nothing >= 0 && ::dup2(nothing, 0) >= 0 && ::dup2(output, 1) >= 0 &&
                     ::dup2(error_file >= 0 ? error_file : output, 2) >= 0 && (*folder == 0 || ::chdir(folder) == 0);
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE, SIGXFSZ}) ::signal(signal, SIG_DFL);
  if (!holds_locks) ::close_range(3, ~0U, CLOSE_RANGE_CLOEXEC);
  if (ready) ::execve(program, arguments, variables);
  const int reason = errno;
  [[maybe_unused]] const auto written = ::write(report, &reason, sizeof reason);
  ::_exit(127);
}

/// −1 for no file.
int opened_for_errors(const fs::path& file) {
  if (file.empty()) return -1;
  const int opened = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (opened < 0) throw system_failure(fmt::format("cannot write '{}'", file.string()), errno);
  return opened;
}

ChildEnd end_of(int status) {
  if (WIFSIGNALED(status)) return {.exit_code = 0, .signal = WTERMSIG(status)};
  return {.exit_code = WEXITSTATUS(status), .signal = 0};
}

}  // namespace

std::optional<fs::path> find_program(const std::string& name) {
  if (name.find('/') != std::string::npos)
    return ::access(name.c_str(), X_OK) == 0 ? std::optional(fs::absolute(name)) : std::nullopt;
  const char* path = std::getenv("PATH");
  std::string folders = path ? path : "/usr/local/bin:/usr/bin:/bin";
  for (std::size_t start = 0; start <= folders.size();) {
    const std::size_t end = std::min(folders.find(':', start), folders.size());
    const fs::path candidate = fs::path(folders.substr(start, end - start)) / name;
    if (std::error_code ignored; fs::is_regular_file(candidate, ignored) && ::access(candidate.c_str(), X_OK) == 0)
      return candidate;
    start = end + 1;
  }
  return std::nullopt;
}

ChildProcess::ChildProcess(const ChildCommand& command) {
  const auto program = find_program(command.words.front());
  if (!program)
    throw Error(command.if_not_started,
                fmt::format("'{}' cannot be started: no such program in PATH", command.words.front()));
  std::vector<std::string> words = command.words, variables = all_variables(command.environment);
  std::vector<char*> argument_pointers = pointers(words), variable_pointers = pointers(variables);
  const int error_file = opened_for_errors(command.standard_error);
  const Pipe output, report;
  const pid_t parent = ::getpid();
  pid_ = ::fork();
  if (pid_ == 0)
    become(program->c_str(), argument_pointers.data(), variable_pointers.data(), command.folder.c_str(), error_file,
           output.write, report.write, parent, command.holds_locks);
  if (error_file >= 0) ::close(error_file);
  ::close(output.write);
  ::close(report.write);
  output_ = output.read;
  int reason = 0;
  const bool failed = pid_ < 0 || ::read(report.read, &reason, sizeof reason) == sizeof reason;
  ::close(report.read);
  if (failed) {
    if (pid_ > 0) ::waitpid(pid_, nullptr, 0);
    ::close(output_);
    throw Error(command.if_not_started,
                fmt::format("'{}' cannot be started: {}", program->string(), std::strerror(reason)));
  }
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)),
      output_(std::exchange(other.output_, -1)),
      unread_(std::move(other.unread_)),
      end_(other.end_) {}

ChildProcess::~ChildProcess() {
  if (pid_ > 0 && !end_) stop();
  if (output_ >= 0) ::close(output_);
}

bool ChildProcess::read_more() {
  char buffer[65536];
  const ssize_t got = ::read(output_, buffer, sizeof buffer);
  if (got < 0 && (errno == EINTR || errno == EAGAIN)) return true;
  if (got <= 0) {
    ::close(std::exchange(output_, -1));
    return false;
  }
  unread_.append(buffer, static_cast<std::size_t>(got));
  return true;
}

std::vector<std::string> ChildProcess::read_lines() {
  read_more();
  std::vector<std::string> lines;
  for (std::size_t end; (end = unread_.find('\n')) != std::string::npos;) {
    lines.push_back(unread_.substr(0, end));
    unread_.erase(0, end + 1);
  }
  return lines;
}

std::string ChildProcess::read_to_end() {
  while (output_ >= 0) {
    pollfd readable{output_, POLLIN, 0};
    const int ready = ::poll(&readable, 1, 1000);
    if (interrupted()) {
      stop();
      throw Error(ExitCode::interrupted, "interrupted");
    }
    if (ready > 0) read_more();
  }
  return std::exchange(unread_, {});
}

ChildEnd ChildProcess::wait() {
  int status = 0;
  while (!end_) {
    if (::waitpid(pid_, &status, 0) == pid_)
      end_ = end_of(status);
    else if (errno != EINTR)
      end_ = ChildEnd{.exit_code = 127};
  }
  return *end_;
}

void ChildProcess::ask_to_stop() {
  if (!end_) ::kill(-pid_, SIGTERM);
}

ChildEnd ChildProcess::stop() {
  using namespace std::chrono_literals;
  if (end_) return *end_;
  for (int signal : {SIGTERM, SIGKILL}) {
    ::kill(-pid_, signal);
    for (int i = 0; i < 50 && !end_; ++i) {
      int status = 0;
      if (::waitpid(pid_, &status, WNOHANG) == pid_)
        end_ = end_of(status);
      else
        std::this_thread::sleep_for(20ms);
    }
  }
  ::kill(-pid_, SIGKILL);  // whatever of the group is left
  return wait();
}

}  // namespace validate
