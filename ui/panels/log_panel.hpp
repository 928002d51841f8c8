// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>

class QPlainTextEdit;

namespace sonde::ui {

/// The dock of messages: everything that the status line showed or had no room for, with the time
/// of day, to read again and copy.
class LogPanel : public QDockWidget {
 public:
  explicit LogPanel(QWidget* parent = nullptr);
  /// One line; nothing where it is empty, or the same as the one before.
  void add(const QString& message);
  QString text() const;
  /// A few lines: the view is above it.
  QSize sizeHint() const override { return {360, 130}; }

 private:
  QPlainTextEdit* lines_;
  QString last_;
};

}  // namespace sonde::ui
