// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/tuner.hpp"

#include <QFileInfo>
#include <memory>
#include <utility>

namespace sonde::ui {

Tuner::Tuner(QWidget& window, Prompts& prompts) : prompts_(prompts), job_(&window) {}

void Tuner::load(const QString& folder, const LoadedScene& opened) {
  begin(QStringLiteral("Reading %1").arg(QFileInfo(folder).fileName()),
        [path = std::filesystem::path(folder.toStdString()), opened](const Progress&) {
          return load_tuning(path, opened);
        });
}

void Tuner::compute(const TuningOrder& order, const LoadedScene& opened) {
  begin(QStringLiteral("Studying the gains of %1").arg(QString::fromStdString(order.device.name)),
        [order, opened](const Progress& progress) {
          return compute_tuning(order, opened, progress);
        });
}

void Tuner::begin(const QString& what, std::function<Tuning(const Progress&)> work) {
  const auto tuning = std::make_shared<Tuning>();
  job_.start(
      what,
      [tuning, work = std::move(work)](const Progress& progress) { *tuning = work(progress); },
      [this, tuning](const std::exception_ptr& error) {
        if (!error) return ready(std::move(*tuning));
        const QString reason = reason_of(error);
        if (!reason.isEmpty() && prompts_.report_error) prompts_.report_error(reason);
        if (failed) failed(reason);
      });
}

}  // namespace sonde::ui
