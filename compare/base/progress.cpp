#include "compare/base/progress.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "compare/base/standard_streams.hpp"
#include "compare/base/terminal.hpp"

namespace validate {

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

Progress::Progress(bool quiet) : quiet_(quiet), terminal_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() { status(""); }

void Progress::say(std::string_view line) {
  if (quiet_) return;
  status("");
  print_remark(fmt::format("{:6.1f} s  {}\n", elapsed_s(), line));
}

void Progress::status(std::string_view line) {
  if (quiet_ || !terminal_ || (line.empty() && !shown_)) return;
  print_remark(fmt::format("\r\033[K{}", cut_to(line, remark_width() - 1)));  // the last place may begin a new line
  shown_ = !line.empty();
}

double Progress::elapsed_s() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

std::string bar(double fraction) {
  constexpr int width = 24;
  const double inside = std::clamp(fraction, 0.0, 1.0);
  const int full = static_cast<int>(inside * width);
  return fmt::format("[{}{}] {:3.0f} %", std::string(full, '#'), std::string(width - full, '.'), 100 * inside);
}

}  // namespace validate
