// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/interrupt.hpp"

#include <signal.h>
#include <unistd.h>

#include <atomic>

namespace sonde::app {
namespace {

constexpr int interrupted_exit_code = 130;
// The handler may run in any thread.
std::atomic<bool> writing{false};
std::atomic<bool> noting{false};
std::atomic<bool> noted{false};
static_assert(std::atomic<bool>::is_always_lock_free);

// Not cooperative by default: a single search may run for minutes, and there is nothing to undo.
extern "C" void on_interrupt(int) {
  if (noting.load()) return noted.store(true);
  if (!writing.load()) _exit(interrupted_exit_code);
}

}  // namespace

void catch_interrupts() {
  struct sigaction action = {};
  action.sa_handler = on_interrupt;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // Who reads the results may go away: then writing fails, and what is half written is taken away.
  signal(SIGPIPE, SIG_IGN);
}

void finish_despite_interrupts() { writing.store(true); }

void note_interrupts() { noting.store(true); }
bool interrupt_noted() { return noted.load(); }

}  // namespace sonde::app
