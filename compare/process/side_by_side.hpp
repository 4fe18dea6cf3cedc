// Several programs at a time, each started as soon as there are cores for it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/base/child_process.hpp"

namespace validate {

/// What the owner of the programs does; each is known by its index.
struct SideBySide {
  std::function<std::optional<ChildProcess>(std::size_t)> start;      ///< nothing: there is none to wait for
  std::function<void(std::size_t, const std::string&)> on_line = {};  ///< of its standard output
  std::function<void(std::size_t, const ChildEnd&)> on_end = {};
};

/// Starts one program for each number of cores wanted, in their order and as many at a time as `cores` hold (one that
/// wants more runs alone), and waits for all. Throws Error (interrupted) after stopping all when a signal has come.
void run_side_by_side(const std::vector<int>& wanted, int cores, const SideBySide& owner);

}  // namespace validate
