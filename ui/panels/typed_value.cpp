// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/typed_value.hpp"

#include <QKeyEvent>
#include <QMainWindow>
#include <algorithm>
#include <cmath>

#include "ui/base/format.hpp"

namespace sonde::ui {

TypedValue::TypedValue(const Setting& setting, QWidget* parent)
    : QDoubleSpinBox(parent), setting_(setting) {
  setLocale(QLocale::c());
  setDecimals(9);  // the text is shorter; this only keeps small values from being rounded off
  setRange(setting.minimum, setting.maximum);
  if (*setting.unit) setSuffix(' ' + QString::fromUtf8(setting.unit));
  setAlignment(Qt::AlignRight);
  setKeyboardTracking(false);  // half a typed number is not a gain
  setAccelerated(true);
}

void TypedValue::stepBy(int steps) {
  if (setting_.logarithmic)
    setValue(value() * std::pow(1.1, steps));
  else
    setValue(value() + steps * (setting_.maximum - setting_.minimum) / 100);
  selectAll();
}

QString TypedValue::textFromValue(double value) const {
  if (setting_.integer || (std::abs(value) >= 1000 && std::abs(value) < 1e7))
    return QString::number(value, 'f', 0);
  return QString::number(value, 'g', 4);
}

/// A box takes every key that types something, and so the window's own letters.
bool TypedValue::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto& key = static_cast<const QKeyEvent&>(*event);
    const bool letter =
        (key.key() >= Qt::Key_A && key.key() <= Qt::Key_Z) || key.key() == Qt::Key_Space;
    const bool plain = !(key.modifiers() & ~Qt::ShiftModifier);
    if (plain && letter && key.key() != Qt::Key_E) {  // 2e3
      event->ignore();
      return false;
    }
  }
  return QDoubleSpinBox::event(event);
}

void TypedValue::keyPressEvent(QKeyEvent* event) {
  QDoubleSpinBox::keyPressEvent(event);
  if (event->key() != Qt::Key_Return && event->key() != Qt::Key_Enter) return;
  for (QWidget* up = parentWidget(); up; up = up->parentWidget())
    if (auto* main = qobject_cast<QMainWindow*>(up); main && main->centralWidget())
      return main->centralWidget()->setFocus(Qt::OtherFocusReason);
}

QString TypedValue::bare(const QString& text) const {
  QString number = text;
  if (!suffix().isEmpty() && number.endsWith(suffix())) number.chop(suffix().size());
  return number.trimmed().replace(',', '.');
}

double TypedValue::valueFromText(const QString& text) const {
  return QLocale::c().toDouble(bare(text));
}

QValidator::State TypedValue::validate(QString& text, int& /*position*/) const {
  const QString number = bare(text);
  bool ok = false;
  const double value = QLocale::c().toDouble(number, &ok);
  if (ok && value >= minimum() && value <= maximum()) return QValidator::Acceptable;
  const bool may_become_one = std::all_of(number.begin(), number.end(), [](QChar c) {
    return c.isDigit() || c == '.' || c == '-' || c == '+' || c == 'e' || c == 'E';
  });
  return may_become_one ? QValidator::Intermediate : QValidator::Invalid;
}

}  // namespace sonde::ui
