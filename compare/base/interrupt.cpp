#include "compare/base/interrupt.hpp"

#include <csignal>
#include <initializer_list>

namespace validate {
namespace {

volatile std::sig_atomic_t signals_seen = 0;

void note_signal(int signal) {
  if (signals_seen) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  signals_seen = 1;
}

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = note_signal;
  sigemptyset(&action.sa_mask);
  for (int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);  // no SA_RESTART: poll() returns
}

bool interrupted() { return signals_seen != 0; }

}  // namespace validate
