#include "compare/process/side_by_side.hpp"

#include <poll.h>

#include <list>

#include "compare/base/interrupt.hpp"

namespace validate {
namespace {

struct Running {
  std::size_t index;
  ChildProcess child;
};

void read_output(std::list<Running>& running, const SideBySide& owner) {
  std::vector<pollfd> descriptors;
  for (const Running& one : running) descriptors.push_back({one.child.output(), POLLIN, 0});
  ::poll(descriptors.data(), descriptors.size(), 1000);
  if (interrupted()) {
    for (Running& one : running) one.child.ask_to_stop();
    for (Running& one : running) one.child.stop();
    throw Error(ExitCode::interrupted, "interrupted");
  }
  auto descriptor = descriptors.begin();
  for (Running& one : running) {
    if ((descriptor++)->revents == 0) continue;
    for (const std::string& line : one.child.read_lines())
      if (owner.on_line) owner.on_line(one.index, line);
  }
}

}  // namespace

void run_side_by_side(const std::vector<int>& wanted, int cores, const SideBySide& owner) {
  std::list<Running> running;
  std::size_t next = 0;
  int busy = 0;
  while (next < wanted.size() || !running.empty()) {
    while (next < wanted.size() && (running.empty() || busy + wanted[next] <= cores)) {
      const std::size_t index = next++;
      std::optional<ChildProcess> child = owner.start(index);
      if (!child) continue;
      running.push_back({index, std::move(*child)});
      busy += wanted[index];
    }
    if (running.empty()) continue;
    read_output(running, owner);
    running.remove_if([&](Running& one) {
      if (one.child.output() >= 0) return false;
      busy -= wanted[one.index];
      owner.on_end(one.index, one.child.wait());
      return true;
    });
  }
}

}  // namespace validate
