// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/number_field.hpp"

#include <QKeyEvent>
#include <QMainWindow>
#include <cmath>
#include <limits>

#include "engine/text/number_text.hpp"

namespace sonde::ui {
namespace {

constexpr int field_digits = 7;

}  // namespace

bool NumberField::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto& key = static_cast<const QKeyEvent&>(*event);
    const bool letter = key.key() >= Qt::Key_A && key.key() <= Qt::Key_Z;
    const bool plain = !(key.modifiers() & ~Qt::ShiftModifier);
    if (plain && (letter || key.key() == Qt::Key_Space) && key.key() != Qt::Key_E) {
      event->ignore();
      return false;
    }
  }
  return QLineEdit::event(event);
}

void NumberField::keyPressEvent(QKeyEvent* event) {
  QLineEdit::keyPressEvent(event);
  if (event->key() != Qt::Key_Return && event->key() != Qt::Key_Enter) return;
  for (QWidget* up = parentWidget(); up; up = up->parentWidget())
    if (auto* main = qobject_cast<QMainWindow*>(up); main && main->centralWidget())
      return main->centralWidget()->setFocus(Qt::OtherFocusReason);
}

double NumberField::number() const {
  return parse_number(text().trimmed().replace(',', '.').toStdString())
      .value_or(std::numeric_limits<double>::quiet_NaN());
}

void NumberField::show_number(double value) { setText(number_in_field(value)); }

QString number_in_field(double value) {
  if (std::abs(value) < 1e-9) value = 0;  // rounding
  return QString::fromStdString(number_text(value, field_digits));
}

}  // namespace sonde::ui
