// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/platform/end_signals.hpp"

#include <atomic>
#include <csignal>
#include <cstdlib>

namespace sonde {
namespace {

std::atomic<void (*)(int)> handler_of{nullptr};

void call(int number) {
  if (void (*const handler)(int) = handler_of.load()) handler(number);
}

// Whether a handler stays after a signal differs between systems, so each says it.
extern "C" void call_always(int number) {
  std::signal(number, call_always);
  call(number);
}
extern "C" void call_once(int number) {
  std::signal(number, SIG_DFL);
  call(number);
}

}  // namespace

void on_end_signal(void (*handler)(int), HandledSignals which) noexcept {
  handler_of = handler;
  for (const int number : {SIGINT, SIGTERM})
    std::signal(number, which == HandledSignals::all ? call_always : call_once);
}

void survive_broken_pipes() noexcept {}

void end_at_once(int exit_code) noexcept { std::_Exit(exit_code); }

int EndPipe::open() noexcept { return -1; }
void EndPipe::tell_from_handler() noexcept {}

}  // namespace sonde
