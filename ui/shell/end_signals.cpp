// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/end_signals.hpp"

#include <QSocketNotifier>
#include <utility>

#include "engine/platform/end_signals.hpp"

namespace sonde::ui {
namespace {

extern "C" void tell(int) { EndPipe::tell_from_handler(); }

}  // namespace

void when_told_to_end(QObject* owner, std::function<void()> told) {
  const int end = EndPipe::open();
  if (end < 0) return;  // signals end the program as ever
  auto* notifier = new QSocketNotifier(end, QSocketNotifier::Read, owner);
  QObject::connect(notifier, &QSocketNotifier::activated, owner,
                   [notifier, told = std::move(told)] {
                     notifier->setEnabled(false);
                     told();
                   });
  on_end_signal(tell, HandledSignals::first);
}

}  // namespace sonde::ui
