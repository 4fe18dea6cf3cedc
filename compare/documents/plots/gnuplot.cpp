#include "compare/documents/plots/gnuplot.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "compare/base/child_process.hpp"

namespace validate {

std::optional<GnuplotReport> run_gnuplot(const std::filesystem::path& script) {
  const auto program = find_program("gnuplot");
  if (!program) return std::nullopt;
  // -d: what the user has set up for himself changes no figure.
  const std::filesystem::path whole = std::filesystem::absolute(script);
  ChildProcess child({.words = {std::filesystem::absolute(*program).string(), "-d", whole.filename().string()},
                      .folder = whole.parent_path(),
                      .if_not_started = ExitCode::file_failed,
                      .holds_locks = false});
  GnuplotReport report{.succeeded = false, .messages = child.read_to_end()};
  const ChildEnd end = child.wait();
  report.succeeded = end.good();
  if (end.signal) report.messages += fmt::format("ended by signal {}", end.signal);
  return report;
}

std::string gnuplot_quoted(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace validate
