// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QTimer>
#include <exception>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "engine/base/error.hpp"

class QWidget;

namespace sonde::ui {

class ProgressDialog;

/// The message to the user about an error; empty for Cancelled.
QString reason_of(const std::exception_ptr& error);

/// Long work in its own thread, with a progress dialog that can cancel it once it takes longer than
/// a moment, or, where `watched` is set, with none: then everything else goes on, and the work has
/// a lower priority than that. One piece of work at a time: starting another abandons the first,
/// and its end is not reported.
class Job : public QObject {
  Q_OBJECT
 public:
  explicit Job(QWidget* window);
  ~Job() override;  ///< asks the work to stop and waits for it

  /// `work` runs in the thread and reports its progress. `done` runs in the window's thread with
  /// the exception of the work (null if none; Cancelled if the user cancelled).
  void start(const QString& what, std::function<void(const Progress&)> work,
             std::function<void(std::exception_ptr)> done);
  bool running() const { return current_ != nullptr; }
  /// Abandons the work: its end is not reported.
  void abandon();
  /// As the dialog's button: ends in `done` with Cancelled. Nothing where nothing runs.
  void cancel();
  /// Before the start: the work runs behind the servo and the picture, and progressed() takes the
  /// place of a dialog.
  void stay_back() { stays_back_ = true; }

 signals:
  /// The fraction done, in the window's thread, of work that stays back, and s since its start.
  void progressed(double fraction, double elapsed);

 private:
  struct Task;
  void poll();
  void finish(std::exception_ptr error);

  QWidget* window_;
  QTimer timer_;
  std::shared_ptr<Task> current_;
  std::vector<std::shared_ptr<Task>> abandoned_;  ///< still running out
  std::function<void(std::exception_ptr)> done_;
  ProgressDialog* dialog_ = nullptr;
  bool stays_back_ = false;
};

}  // namespace sonde::ui
