// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/interrupt.hpp"

#include <signal.h>
#include <unistd.h>

namespace sonde::app {
namespace {

constexpr int interrupted_exit_code = 130;
volatile sig_atomic_t writing = 0;

// Not cooperative on purpose: a single search may run for minutes, and there is nothing to undo.
extern "C" void on_interrupt(int) {
  if (writing == 0) _exit(interrupted_exit_code);
}

}  // namespace

void catch_interrupts() {
  struct sigaction action = {};
  action.sa_handler = on_interrupt;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
}

void finish_despite_interrupts() { writing = 1; }

}  // namespace sonde::app
