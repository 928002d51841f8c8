// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <functional>
#include <memory>

#include "ui/actions/prompts.hpp"
#include "ui/base/job.hpp"
#include "ui/panels/study_box.hpp"
#include "ui/tuning/tuning.hpp"

namespace sonde::ui {

/// Loads, computes and saves tunings in a worker. While it computes everything else goes on, and
/// rows are told of as they are found. On bad input, or when the user stops it, it reports only the
/// reason.
class Tuner : public QObject {
  Q_OBJECT
 public:
  Tuner(QWidget& window, Prompts& prompts);
  ~Tuner() override;

  void load(const QString& folder, const LoadedScene& opened);
  /// Goes on from the rows that are there.
  void compute(const TuningOrder& order, const LoadedScene& opened);
  void save(const Tuning& tuning, const QString& folder, const LoadedScene& opened);
  bool computing() const { return computing_.running(); }
  void stop() { computing_.cancel(); }
  void abandon();  ///< the pair it is about has gone

 signals:
  void ready(const Tuning& tuning);  ///< also with each row that is found
  void progressed(const std::optional<StudyProgress>& progress);  ///< none: it has ended
  /// Nothing was loaded: the reason (empty if the user gave up) was reported already.
  void failed(const QString& reason);

 private:
  struct Found;
  void begin(const QString& what, std::function<Tuning(const Progress&)> work);
  void look(double fraction);
  void complain(const std::exception_ptr& error);

  Prompts& prompts_;
  Job job_, computing_;
  std::shared_ptr<Found> found_;
  QElapsedTimer since_first_;  ///< row that was found, be it one of before
  double newest_at_ = 0;       ///< s after that
  QElapsedTimer since_start_;
  double done_before_ = 0;  ///< part of the work that rows of before had done
  std::size_t first_ = 0, rows_ = 0, of_rows_ = 0;
  QString device_;
};

/// How long the missing rows take if they take as long as those that were computed in so many
/// seconds, the last of them `since` seconds ago: "about 40 s left". Empty before the first.
QString time_left_text(double seconds, std::size_t computed, std::size_t missing, double since);

}  // namespace sonde::ui
