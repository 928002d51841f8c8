// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/platform/end_signals.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>

namespace sonde {
namespace {

std::atomic<int> write_end{-1};
static_assert(std::atomic<int>::is_always_lock_free);

}  // namespace

void on_end_signal(void (*handler)(int), HandledSignals which) noexcept {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  if (which == HandledSignals::first) action.sa_flags |= static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

void survive_broken_pipes() noexcept { signal(SIGPIPE, SIG_IGN); }

void end_at_once(int exit_code) noexcept { _exit(exit_code); }

int EndPipe::open() noexcept {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC | O_NONBLOCK) != 0) return -1;
  write_end = ends[1];
  return ends[0];
}

// A byte in a pipe is all that is safe.
void EndPipe::tell_from_handler() noexcept {
  const char told = 1;
  [[maybe_unused]] const ssize_t written = ::write(write_end.load(), &told, 1);
}

}  // namespace sonde
