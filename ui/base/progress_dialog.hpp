// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QLabel;
class QProgressBar;

namespace sonde::ui {

/// Shows the present work, its progress, how long it will take, and a button to cancel it. Esc and
/// closing also cancel, and emit rejected(). Only its owner shows and hides it. QProgressDialog
/// does not do that: its own timer shows it after four seconds, finished or not, and it takes Esc
/// before anybody else sees it.
class ProgressDialog : public QDialog {
 public:
  ProgressDialog(const QString& what, QWidget* parent);
  /// That part of the work is done, after so many s.
  void show_progress(double fraction, double elapsed);

 private:
  QProgressBar* bar_;
  QLabel* left_;
};

}  // namespace sonde::ui
