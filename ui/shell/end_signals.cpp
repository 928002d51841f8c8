// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/end_signals.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <QSocketNotifier>
#include <utility>

namespace sonde::ui {
namespace {

int write_end = -1;

// A signal may come in the middle of anything: a byte in a pipe is all that is safe.
extern "C" void on_end_signal(int) {
  const char told = 1;
  [[maybe_unused]] const ssize_t written = write(write_end, &told, 1);
}

void catch_signals() {
  struct sigaction action = {};
  action.sa_handler = on_end_signal;
  action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

}  // namespace

void when_told_to_end(QObject* owner, std::function<void()> told) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC | O_NONBLOCK) != 0) return;  // signals end the program as ever
  write_end = ends[1];
  auto* notifier = new QSocketNotifier(ends[0], QSocketNotifier::Read, owner);
  QObject::connect(notifier, &QSocketNotifier::activated, owner,
                   [notifier, told = std::move(told)] {
                     notifier->setEnabled(false);
                     told();
                   });
  catch_signals();
}

}  // namespace sonde::ui
