// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/job.hpp"

#include <QElapsedTimer>
#include <atomic>
#include <utility>

#include "engine/platform/real_time.hpp"
#include "ui/base/progress_dialog.hpp"

namespace sonde::ui {
namespace {

constexpr int patience_ms = 600;  // before a dialog appears
constexpr int poll_ms = 8;

}  // namespace

QString reason_of(const std::exception_ptr& error) {
  try {
    std::rethrow_exception(error);
  } catch (const Cancelled&) {
    return {};
  } catch (const InputError& bad) {
    return QString::fromStdString(bad.what());
  } catch (const std::bad_alloc&) {
    return QStringLiteral("There is not enough memory for these meshes.");
  } catch (const std::exception& fault) {
    return QStringLiteral("An error of the program: ") + QString::fromUtf8(fault.what());
  }
}

struct Job::Task {
  std::atomic<double> fraction = 0;
  std::atomic<bool> cancelled = false;
  std::atomic<bool> ended = false;
  std::exception_ptr error;  ///< set before `ended`
  QElapsedTimer since;
  std::thread thread;
  ~Task() {
    cancelled = true;
    if (thread.joinable()) thread.join();
  }
};

Job::Job(QWidget* window) : window_(window) {
  connect(&timer_, &QTimer::timeout, this, &Job::poll);
}

Job::~Job() { abandon(); }

void Job::start(const QString& what, std::function<void(const Progress&)> work,
                std::function<void(std::exception_ptr)> done) {
  abandon();
  auto task = std::make_shared<Task>();
  task->since.start();
  done_ = std::move(done);
  if (!stays_back_) {
    dialog_ = new ProgressDialog(what, window_);
    connect(dialog_, &QDialog::rejected, this, &Job::cancel);
  }
  Task* shared = task.get();  // outlives the thread: its destructor joins
  task->thread = std::thread([shared, stays_back = stays_back_, work = std::move(work)] {
    if (stays_back) stand_back();
    try {
      work([shared](double fraction) {
        shared->fraction = fraction;
        return !shared->cancelled;
      });
    } catch (...) {
      shared->error = std::current_exception();
    }
    shared->ended = true;
  });
  current_ = std::move(task);
  timer_.start(poll_ms);
}

void Job::poll() {
  std::erase_if(abandoned_, [](const auto& task) { return task->ended.load(); });
  if (!current_) {
    if (abandoned_.empty()) timer_.stop();
    return;
  }
  if (current_->ended) {
    const std::exception_ptr error = current_->error;
    finish(error);
    return;
  }
  if (stays_back_) {
    emit progressed(current_->fraction, 1e-3 * double(current_->since.elapsed()));
    return;
  }
  if (current_->since.elapsed() < patience_ms) return;
  if (!dialog_->isVisible()) dialog_->show();
  dialog_->show_progress(current_->fraction, 1e-3 * double(current_->since.elapsed()));
}

void Job::cancel() {
  if (current_) finish(std::make_exception_ptr(Cancelled()));
}

void Job::finish(std::exception_ptr error) {
  const auto done = std::move(done_);
  abandon();
  if (done) done(error);
}

void Job::abandon() {
  done_ = nullptr;
  if (dialog_) {
    dialog_->disconnect(this);
    dialog_->hide();
    dialog_->deleteLater();
    dialog_ = nullptr;
  }
  if (!current_) return;
  current_->cancelled = true;
  abandoned_.push_back(std::move(current_));
  current_ = nullptr;
}

}  // namespace sonde::ui
