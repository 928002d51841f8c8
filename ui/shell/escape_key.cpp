// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/escape_key.hpp"

#include <QApplication>
#include <QDialog>
#include <QKeyEvent>
#include <cstdint>
#include <cstring>
#include <utility>

namespace sonde::ui {
namespace {

/// What Esc closes: in front of the window, and the window itself is none.
QWidget* open_in_front() {
  if (QWidget* popup = QApplication::activePopupWidget()) return popup;
  if (QWidget* modal = QApplication::activeModalWidget()) return modal;
  return qobject_cast<QDialog*>(QApplication::activeWindow());
}

/// Qt drops a key for a window that a dialog blocks: then nobody would close that dialog. A list or
/// a menu gets its keys wherever they go.
void close_where_blocked(std::uint32_t key_of) {
  QWidget* modal = QApplication::activeModalWidget();
  if (!modal || QApplication::activePopupWidget() || modal->winId() == key_of) return;
  QMetaObject::invokeMethod(modal, "close", Qt::QueuedConnection);
}

}  // namespace

EscapeKey::EscapeKey(std::function<bool()> first) : first_(std::move(first)) {
  QApplication::instance()->installEventFilter(this);
  QApplication::instance()->installNativeEventFilter(this);
}

EscapeKey::~EscapeKey() {
  // Gone already where the application has ended first.
  if (QApplication::instance()) QApplication::instance()->removeNativeEventFilter(this);
}

void EscapeKey::decide() {
  closes_ = open_in_front() && !first_();
  if (!closes_) emit pressed();
}

/// A shortcut takes the press away from everybody, so the question before, whether somebody else
/// wants the key, counts as well.
bool EscapeKey::eventFilter(QObject* /*watched*/, QEvent* event) {
  const bool press = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
  const bool release = event->type() == QEvent::KeyRelease;
  if ((!press && !release) || static_cast<const QKeyEvent*>(event)->key() != Qt::Key_Escape)
    return false;
  if (release)
    closes_ = false;
  else if (!closes_)
    decide();
  return false;
}

/// With no window manager, or a focus that follows the mouse, keys go to the window below while a
/// dialog is open, and Qt drops them before any filter of events.
bool EscapeKey::nativeEventFilter(const QByteArray& type, void* message, long* /*result*/) {
  // As the X protocol has it: the kind of event, with a bit for those that clients send; the key;
  // and, after a sequence number, a time and the root, the window that the key is for.
  constexpr std::uint8_t press = 2, kind = 0x7f, escape = 9;
  constexpr std::size_t window_at = 12;
  const auto* bytes = static_cast<const std::uint8_t*>(message);
  if (type != "xcb_generic_event_t" || (bytes[0] & kind) != press || bytes[1] != escape)
    return false;
  decide();
  std::uint32_t window = 0;
  std::memcpy(&window, bytes + window_at, sizeof window);
  close_where_blocked(window);
  return false;
}

}  // namespace sonde::ui
