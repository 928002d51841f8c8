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

/// What to tell the user of an error; empty of Cancelled.
QString reason_of(const std::exception_ptr& error);

/// Long work in a thread of its own, with a progress dialog that can cancel it once it takes longer
/// than a moment. One piece of work at a time: starting another abandons the first, whose end is
/// then not heard of.
class Job : public QObject {
 public:
  explicit Job(QWidget* window);
  ~Job() override;  ///< asks the work to stop and waits for it

  /// `work` runs in the thread and reports its progress; `done` runs in the window's thread with
  /// what the work threw (null if nothing; Cancelled if the user gave up).
  void start(const QString& what, std::function<void(const Progress&)> work,
             std::function<void(std::exception_ptr)> done);
  bool running() const { return current_ != nullptr; }
  /// Nothing more is heard of the work.
  void abandon();

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
};

}  // namespace sonde::ui
