// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>

#include "engine/settings/settings.hpp"

namespace sonde::ui {

/// A box to type the value of a setting: it shows the unit, accepts '.' or ',' as the decimal
/// point, and steps by a tenth (of the value where the setting is logarithmic, else of the range's
/// tenth). Keys that are not part of a number go to the window, and Enter returns the keyboard to
/// it.
class TypedValue : public QDoubleSpinBox {
 public:
  TypedValue(const Setting& setting, QWidget* parent);
  void stepBy(int steps) override;
  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& position) const override;

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QString bare(const QString& text) const;
  Setting setting_;
};

}  // namespace sonde::ui
