// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>

namespace sonde::ui {

/// A field for a number. Letters that are no part of one stay commands of the window, as in the
/// other docks; Enter gives the keyboard back to the view.
class NumberField : public QLineEdit {
 public:
  using QLineEdit::QLineEdit;
  /// What is typed, '.' or ',' as the decimal point; not a number where it is none.
  double number() const;
  void show_number(double value);

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
};

/// A number in as few digits as seven hold; 0 for what is rounding.
QString number_in_field(double value);

}  // namespace sonde::ui
