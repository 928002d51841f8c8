// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/interrupt.hpp"

#include <atomic>

#include "engine/platform/end_signals.hpp"

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
  if (!writing.load()) end_at_once(interrupted_exit_code);
}

}  // namespace

void catch_interrupts() {
  on_end_signal(on_interrupt, HandledSignals::all);
  // Who reads the results may go away: then writing fails, and what is half written is taken away.
  survive_broken_pipes();
}

void finish_despite_interrupts() { writing.store(true); }

void note_interrupts() { noting.store(true); }
bool interrupt_noted() { return noted.load(); }

}  // namespace sonde::app
