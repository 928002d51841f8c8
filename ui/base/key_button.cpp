// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/key_button.hpp"

#include <QKeyEvent>

namespace sonde::ui {

bool KeyButton::event(QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)
    return QToolButton::event(event);
  const auto& key = static_cast<const QKeyEvent&>(*event);
  const bool enter = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
  const bool plain = key.modifiers() == Qt::NoModifier || key.modifiers() == Qt::KeypadModifier;
  if (!plain || (!enter && key.key() != Qt::Key_Space)) return QToolButton::event(event);
  event->accept();
  if (event->type() == QEvent::ShortcutOverride) return true;
  if (!enter) return QToolButton::event(event);
  click();
  return true;
}

}  // namespace sonde::ui
