// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/escape_key.hpp"

#include <QApplication>
#include <QKeyEvent>
#include <cstdint>
#include <utility>

namespace sonde::ui {

EscapeKey::EscapeKey(std::function<void()> pressed) : pressed_(std::move(pressed)) {
  QApplication::instance()->installEventFilter(this);
  QApplication::instance()->installNativeEventFilter(this);
}

EscapeKey::~EscapeKey() {
  // Gone already where the application has ended first.
  if (QApplication::instance()) QApplication::instance()->removeNativeEventFilter(this);
}

/// A shortcut takes the press away from everybody, so the question before, whether somebody else
/// wants the key, counts as well.
bool EscapeKey::eventFilter(QObject* /*watched*/, QEvent* event) {
  const bool key = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
  if (key && static_cast<const QKeyEvent*>(event)->key() == Qt::Key_Escape) pressed_();
  return false;
}

/// Qt drops a key for a window that a dialog blocks before any filter of events. With no window
/// manager, or a focus that follows the mouse, that is where keys go while a dialog is open.
bool EscapeKey::nativeEventFilter(const QByteArray& type, void* message, long* /*result*/) {
  // As the X protocol has it: the kind of event, with a bit for those that clients send; the key.
  constexpr std::uint8_t press = 2, kind = 0x7f, escape = 9;
  const auto* bytes = static_cast<const std::uint8_t*>(message);
  if (type == "xcb_generic_event_t" && (bytes[0] & kind) == press && bytes[1] == escape) pressed_();
  return false;
}

}  // namespace sonde::ui
