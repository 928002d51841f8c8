// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QProgressBar;

namespace sonde::ui {

/// What is being done, how far it is, and a button to give it up: Esc and closing do the same, and
/// end in rejected(). It is shown and hidden by its owner alone. QProgressDialog is not: a timer of
/// its own shows it after four seconds, done or not, and it takes Esc before anybody else sees it.
class ProgressDialog : public QDialog {
 public:
  ProgressDialog(const QString& what, QWidget* parent);
  void set_fraction(double fraction);

 private:
  QProgressBar* bar_;
};

}  // namespace sonde::ui
