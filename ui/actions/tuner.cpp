// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/tuner.hpp"

#include <QFileInfo>
#include <cmath>
#include <mutex>
#include <optional>
#include <utility>

#include "ui/base/time_left.hpp"

namespace sonde::ui {

/// What crosses from the worker: the newest of it.
struct Tuner::Found {
  void put(const Tuning& tuning) {
    const std::scoped_lock lock(mutex);
    newest = tuning;
  }
  std::optional<Tuning> take() {
    const std::scoped_lock lock(mutex);
    return std::exchange(newest, std::nullopt);
  }
  std::mutex mutex;
  std::optional<Tuning> newest;
};

QString time_left_text(double seconds, std::size_t computed, std::size_t missing, double since) {
  if (computed == 0) return {};
  return time_left_text(std::max(0.0, seconds / double(computed) * double(missing) - since));
}

Tuner::Tuner(QWidget& window, Prompts& prompts)
    : prompts_(prompts), job_(&window), computing_(&window) {
  computing_.stay_back();
  connect(&computing_, &Job::progressed, this, &Tuner::look);
}

Tuner::~Tuner() = default;

void Tuner::abandon() {
  job_.abandon();
  if (!computing()) return;
  computing_.abandon();
  emit progressed({});
}

void Tuner::load(const QString& folder, const LoadedScene& opened) {
  stop();
  begin(QStringLiteral("Reading %1").arg(QFileInfo(folder).fileName()),
        [path = std::filesystem::path(folder.toStdString()), opened](const Progress&) {
          return load_tuning(path, opened);
        });
}

void Tuner::save(const Tuning& tuning, const QString& folder, const LoadedScene& opened) {
  begin(QStringLiteral("Writing %1").arg(QFileInfo(folder).fileName()),
        [tuning, path = std::filesystem::path(folder.toStdString()), opened](const Progress&) {
          save_tuning(tuning, path);
          return load_tuning(path, opened);
        });
}

void Tuner::begin(const QString& what, std::function<Tuning(const Progress&)> work) {
  const auto tuning = std::make_shared<Tuning>();
  job_.start(
      what,
      [tuning, work = std::move(work)](const Progress& progress) { *tuning = work(progress); },
      [this, tuning](const std::exception_ptr& error) {
        if (error) return complain(error);
        emit ready(*tuning);
      });
}

void Tuner::compute(const TuningOrder& order, const LoadedScene& opened) {
  const auto found = std::make_shared<Found>();
  found_ = found;
  rows_ = of_rows_ = first_ = 0;
  done_before_ = 0;
  since_start_.start();
  device_ = QString::fromStdString(order.device.id);
  computing_.start(
      {},
      [found, order, opened](const Progress& progress) {
        found->put(compute_tuning(order, opened, progress,
                                  [found](const Tuning& so_far) { found->put(so_far); }));
      },
      [this, found](const std::exception_ptr& error) {
        emit progressed({});
        if (auto last = found->take()) emit ready(*last);
        if (error) complain(error);
      });
  look(0);
}

/// The newest rows, and how long the rest will take.
void Tuner::look(double fraction) {
  if (auto so_far = found_->take()) {
    rows_ = so_far->rows;
    of_rows_ = so_far->of_rows;
    if (first_ == 0) {
      first_ = rows_;
      if (fraction < 1) done_before_ = fraction;
      since_first_.start();
    }
    newest_at_ = 1e-3 * double(since_first_.elapsed());
    emit ready(*so_far);
  }
  // By the rows once there are any, before that by the part of the work.
  const double elapsed = 1e-3 * double(since_start_.elapsed());
  const QString by_part = time_left_text(elapsed, (fraction - done_before_) / (1 - done_before_));
  const auto after_comma = [](const QString& left) { return left.isEmpty() ? left : ", " + left; };
  if (rows_ == 0)
    return emit progressed(StudyProgress{
        fraction, QStringLiteral("For %1: contacts and a first look, then the first row%2")
                      .arg(device_, after_comma(by_part))});
  const double now = 1e-3 * double(since_first_.elapsed());
  const QString by_rows =
      time_left_text(newest_at_, rows_ - first_, of_rows_ - rows_, now - newest_at_);
  emit progressed(
      StudyProgress{fraction, QStringLiteral("For %1: %2 of %3 rows%4")
                                  .arg(device_)
                                  .arg(rows_)
                                  .arg(of_rows_)
                                  .arg(after_comma(by_rows.isEmpty() ? by_part : by_rows))});
}

void Tuner::complain(const std::exception_ptr& error) {
  const QString reason = reason_of(error);
  if (!reason.isEmpty() && prompts_.report_error) prompts_.report_error(reason);
  emit failed(reason);
}

}  // namespace sonde::ui
