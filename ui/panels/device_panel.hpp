// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <QStringList>
#include <functional>
#include <vector>

#include "engine/devices/device_settings.hpp"
#include "ui/devices/device_control.hpp"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QGroupBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace sonde::ui {

class AxisTable;
class GripBox;
class SliderRow;

/// The dock of the device: what holds the probe, what else could hold it, the state of a connected
/// device, and how it moves the probe. It hides settings that do not apply to the device.
class DevicePanel : public QDockWidget {
  Q_OBJECT
 public:
  explicit DevicePanel(QWidget* parent = nullptr);

  /// What the probe can be held by. Rebuilds the list only where it differs.
  void show_choices(const std::vector<InputSource>& choices, const InputSource& current);
  /// `from_scene`: the scene brings them, and no change is kept.
  void show_settings(const InputSource& source, const DeviceSettings& settings,
                     bool from_scene = false);
  void show_report(const InputSource& source, const SourceReport& report);
  /// How the loop runs now.
  void show_servo(const ServoSettings& servo);
  /// What the system granted to the loop.
  void show_real_time(const RealTime& granted);
  void show_energy(const HandEnergy& energy);

  /// The hand on a simulated device; hidden while something else holds the probe.
  GripBox& grip() { return *grip_; }

 signals:
  void chosen(const InputSource& source);
  void path_wanted();  ///< one from a file
  /// Immediately, with every change.
  void settings_changed(const DeviceSettings& settings);
  void led_switched(bool on);
  void measure_asked();  ///< of what holds the probe

 private:
  void build_choice(QVBoxLayout& layout);
  void build_state(QVBoxLayout& layout);
  void build_motion(QVBoxLayout& layout);
  void build_loop(QVBoxLayout& layout);
  void build_axes(QVBoxLayout& layout);
  QLabel* number(QFormLayout& form, const char* name, const char* object, const char* doc);
  void show_rows();
  void change(const std::function<void(DeviceSettings&)>& how);

  std::vector<InputSource> choices_;
  QStringList labels_;  ///< of the choices, as they are in the list
  DeviceSettings settings_, usual_;
  bool adjustable_ = false;  ///< a connected device or a simulated one
  bool connected_ = false;
  bool deflections_ = true;  ///< a connected device that reports deflections, not positions
  QComboBox *sources_, *controls_, *frames_;
  QLabel *state_, *what_, *rate_, *lost_, *refused_, *connections_, *clutch_, *latency_,
      *from_scene_;
  QGroupBox *motion_box_, *axes_box_;
  QWidget *numbers_, *choices_row_;
  QCheckBox *led_, *passivity_;
  QPushButton* measure_;
  QLabel *given_, *excess_, *dissipated_, *real_time_;
  SliderRow* rate_row_;
  std::vector<SliderRow*> rows_, axis_rows_;
  AxisTable* axes_;
  GripBox* grip_;
};

}  // namespace sonde::ui
