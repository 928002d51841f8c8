// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>

#include "ui/actions/prompts.hpp"
#include "ui/base/job.hpp"
#include "ui/tuning/tuning.hpp"

namespace sonde::ui {

/// Loads and computes tunings in a worker. On bad input, or when the user cancels, it reports only
/// the reason.
class Tuner : public QObject {
 public:
  Tuner(QWidget& window, Prompts& prompts);

  void load(const QString& folder, const LoadedScene& opened);
  void compute(const TuningOrder& order, const LoadedScene& opened);
  bool running() const { return job_.running(); }
  void abandon() { job_.abandon(); }  ///< the pair it is about has gone

  std::function<void(Tuning)> ready;
  /// Nothing was loaded: the reason (empty if the user gave up) was reported already.
  std::function<void(const QString& reason)> failed;

 private:
  void begin(const QString& what, std::function<Tuning(const Progress&)> work);

  Prompts& prompts_;
  Job job_;
};

}  // namespace sonde::ui
