#include "tests/cli/run_program.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace cli_tests {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void redirect(int descriptor, const fs::path& file, int flags) {
  const int opened = open(file.c_str(), flags, 0600);
  if (opened < 0 || dup2(opened, descriptor) < 0) _exit(126);
  close(opened);
}

[[noreturn]] void become_validate(const std::vector<std::string>& words, const fs::path& folder,
                                  const std::vector<std::string>& environment, const fs::path& streams) {
  if (chdir(folder.c_str()) != 0) _exit(126);
  redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
  redirect(STDOUT_FILENO, streams / "out", O_WRONLY | O_CREAT);
  redirect(STDERR_FILENO, streams / "err", O_WRONLY | O_CREAT);
  for (const std::string& entry : environment) {
    const auto equals = entry.find('=');
    setenv(entry.substr(0, equals).c_str(), entry.substr(equals + 1).c_str(), 1);
  }
  std::vector<char*> arguments = {const_cast<char*>("validate")};
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  execv(VALIDATE_PROGRAM, arguments.data());
  _exit(127);
}

}  // namespace

RunningValidate::RunningValidate(const std::vector<std::string>& words, const fs::path& folder,
                                 const std::vector<std::string>& environment)
    : child_(fork()) {
  if (child_ < 0) throw std::runtime_error("cannot fork");
  if (child_ == 0) become_validate(words, folder, environment, streams_.path());
}

Outcome RunningValidate::wait() {
  int status = 0;
  rusage used{};
  wait4(child_, &status, 0, &used);
  const auto in_ms = [](const timeval& t) { return 1e3 * double(t.tv_sec) + 1e-3 * double(t.tv_usec); };
  return {.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1,
          .out = content_of(streams_.path() / "out"),
          .err = content_of(streams_.path() / "err"),
          .cpu_ms = in_ms(used.ru_utime) + in_ms(used.ru_stime)};
}

Outcome run_validate(const std::vector<std::string>& words, const fs::path& folder,
                     const std::vector<std::string>& environment) {
  return RunningValidate(words, folder, environment).wait();
}

WorkFolder::WorkFolder() {
  std::string name = (fs::temp_directory_path() / "validate-cli-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make " + name);
  path_ = name;
}

WorkFolder::~WorkFolder() { fs::remove_all(path_); }

void WorkFolder::write(const std::string& name, const std::string& content) const {
  std::ofstream(path_ / name, std::ios::binary) << content;
}

}  // namespace cli_tests
