// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QStatusBar>
#include <QString>

#include "engine/haptics/loop/servo.hpp"
#include "ui/base/elided_label.hpp"
#include "ui/devices/device_control.hpp"
#include "ui/document/instant.hpp"
#include "ui/document/session.hpp"

namespace sonde::ui {

/// What stands in the status bar: what happens, what holds the probe, and at which rates.
class StatusLine {
 public:
  explicit StatusLine(QStatusBar& bar);

  void show_happening(const QString& what);
  void show_rates(const Instant& now, Session& session, double frames_per_second, bool simplified);
  void show_source(const InputSource& source, const SourceReport& report);

 private:
  ElidedLabel* happening_;
  QLabel *source_, *rates_;
};

}  // namespace sonde::ui
