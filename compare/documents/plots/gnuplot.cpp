#include "compare/documents/plots/gnuplot.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "compare/base/read_file.hpp"
#include "compare/process/child_process.hpp"

namespace validate {

std::optional<GnuplotReport> run_gnuplot(const std::filesystem::path& script) {
  if (!find_program("gnuplot")) return std::nullopt;
  const std::filesystem::path messages = script.string() + ".messages";
  const ChildEnd end =
      ChildProcess({.words = {"gnuplot", script.string()}, .folder = script.parent_path(), .standard_error = messages})
          .wait();
  GnuplotReport report{.succeeded = end.good(), .messages = read_file(messages)};
  std::filesystem::remove(messages);
  if (end.signal != 0) report.messages += fmt::format("ended by signal {}", end.signal);
  return report;
}

std::string gnuplot_quoted(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace validate
