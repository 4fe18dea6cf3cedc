#include "compare/base/memory.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace validate {
namespace {

std::optional<double> number_in(const std::string& file) {
  std::ifstream in(file);
  double number = 0;
  return in >> number ? std::optional(number) : std::nullopt;  // "max" is none
}

std::optional<double> of_the_system() {
  std::ifstream in("/proc/meminfo");
  std::string word;
  for (double kibibytes = 0; in >> word;)
    if (word == "MemAvailable:" && in >> kibibytes) return 1024 * kibibytes;
  return std::nullopt;
}

/// The control group that a container shows as its own root.
std::optional<double> of_the_group() {
  const auto limit = number_in("/sys/fs/cgroup/memory.max"), used = number_in("/sys/fs/cgroup/memory.current");
  return limit && used ? std::optional(std::max(0.0, *limit - *used)) : std::nullopt;
}

std::optional<double> of_a_process() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return std::nullopt;
  return static_cast<double>(limit.rlim_cur);
}

}  // namespace

std::optional<double> available_memory_bytes() {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& bytes : {of_the_system(), of_the_group(), of_a_process()})
    least = std::min(least, bytes.value_or(least));
  return least < std::numeric_limits<double>::infinity() ? std::optional(least) : std::nullopt;
}

}  // namespace validate
