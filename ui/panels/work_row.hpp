// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

class QLabel;
class QProgressBar;
class QPushButton;

namespace sonde::ui {

/// A button that starts work; while that goes on, how far it is, how long it still takes, and a
/// button that stops it.
class WorkRow : public QWidget {
  Q_OBJECT
 public:
  /// `object`: the button's name; the other one's is `object` + "_stop".
  WorkRow(const QString& text, const QString& object, QWidget* parent);
  /// None: nothing goes on. `elapsed`: s since it began.
  void show_progress(std::optional<double> fraction, double elapsed = 0);
  void set_startable(bool on);

 signals:
  void start_wanted();
  void stop_wanted();

 private:
  QPushButton *start_, *stop_;
  QProgressBar* bar_;
  QLabel* left_;
};

}  // namespace sonde::ui
