// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "ui/actions/measure_dialog.hpp"
#include "ui/actions/prompts.hpp"
#include "ui/base/job.hpp"
#include "ui/devices/device_control.hpp"

namespace sonde::ui {

/// Measures the device that holds the probe: asks, plays the pulses, computes its figures beside
/// the window, and writes them as a profile.
class MeasureControl : public QObject {
  Q_OBJECT
 public:
  MeasureControl(DeviceControl& devices, std::vector<std::filesystem::path> profile_folders,
                 Prompts& prompts, QWidget& window);

  void ask();  ///< for consent; nothing where no device can be measured
  /// Ends what runs, at once.
  void stop(const QString& reason);
  /// No force any more, by whatever: ends the pulses. The computing goes on.
  void force_switched(bool on);
  /// Pushes the hand, or is about to.
  bool going_on() const { return hand_ || job_.running(); }

  /// Why it cannot begin now; empty: it can.
  std::function<QString()> obstacle;

 signals:
  void say(const QString& what);  ///< to the log

 private:
  void show_subject(const QString& profile_id);
  void start();
  void look();
  void compute(const Response& response);
  void take(const std::exception_ptr& error);
  void save();
  void use();
  QString source() const;

  DeviceControl& devices_;
  std::vector<std::filesystem::path> profile_folders_;
  Prompts& prompts_;
  QWidget& window_;
  Job job_;
  QTimer timer_;
  QPointer<MeasureDialog> dialog_;
  MeasureSubject subject_;
  PulsePlan plan_;
  std::shared_ptr<MeasuredHand> hand_;  ///< while pulses are played
  std::shared_ptr<Identification> found_;
  std::optional<DeviceProfile> saved_;
};

}  // namespace sonde::ui
