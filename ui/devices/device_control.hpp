// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "engine/devices/device_settings.hpp"
#include "engine/devices/hotplug_monitor.hpp"
#include "engine/haptics/loop/servo.hpp"
#include "ui/devices/hand_grip.hpp"
#include "ui/devices/input_source.hpp"

namespace sonde {
class MeasuredHand;
struct PulseBounds;
struct PulsePlan;
}  // namespace sonde

namespace sonde::ui {

class Session;

/// The state of what holds the probe, for the user.
struct SourceReport {
  DeviceStatus device;  ///< of a connected one
  /// Of its model, as far as its name tells; none: unknown.
  std::optional<DeviceProfile> profile;
  double reports_per_s = 0;  ///< measured, over about a second
  bool clutch_open = false;
  bool measurable = false;  ///< a device with force holds the probe, or a simulated one
};

/// What holds the probe of the open session: the choice of a device, its connection, and its
/// settings, which are stored in a file for each device.
class DeviceControl : public QObject {
  Q_OBJECT
 public:
  /// Profiles that cannot be read are left out; choosing one by name gives the error.
  DeviceControl(std::filesystem::path settings_folder,
                std::span<const std::filesystem::path> profile_folders);
  ~DeviceControl() override;  ///< keeps what is not kept yet

  /// Applies from now on, to every scene. Before any choice, a scene's own device or the mouse
  /// holds the probe.
  void choose(const InputSource& source);
  const InputSource& source() const { return source_; }
  bool mouse_leads() const;  ///< the mouse moves the probe, or the hand on a simulated device

  /// Another session was opened, and the one before has gone; null for none.
  void attach(Session* session);

  const DeviceSettings& settings() const { return settings_; }
  /// The settings come from the scene: they and all changes to them last until another scene is
  /// opened, and the stored settings stay as they are.
  bool settings_from_scene() const { return from_scene_; }
  /// Acts at once. Stored for the device a moment later, unless the settings come from the scene.
  void set_settings(const DeviceSettings& settings);
  /// How the hand holds a simulated device; acts at once, and is kept.
  const SimulatedGrip& grip() const { return grip_; }
  void set_grip(const SimulatedGrip& grip);
  void set_led(bool on);
  /// The id of the connected device's profile, by its name; empty: none, or not yet known.
  std::string model() const { return profile_ ? profile_->id : std::string(); }
  /// The present settings of the loop: the device's, else the scene's.
  ServoSettings servo() const;

  /// With each frame: the way the picture is seen goes to the device.
  void frame(const Quat& q_FV);
  SourceReport report();
  /// Everything that could hold the probe: the mouse, the scene's path, each device profile, every
  /// connected device, and what holds it now.
  std::vector<InputSource> choices() const;
  /// One more to choose, or in the place of that with its id.
  void add_profile(const DeviceProfile& profile);

  /// Pulses to the device that holds the probe now, whose handle nobody holds meanwhile: no contact
  /// is felt until end_measuring(), another choice or another session. Null where report() has
  /// nothing measurable. Throws std::invalid_argument where it cannot be simulated at this rate.
  std::shared_ptr<MeasuredHand> begin_measuring(const PulsePlan& plan, const PulseBounds& bounds);
  bool measuring() const { return measuring_; }
  void end_measuring();

 signals:
  /// Another source, model, or other settings than those last shown.
  void changed();
  /// Settings that could not be read or kept, a device that cannot be simulated.
  void failed(const QString& reason);

 private:
  void take(const InputSource& source);
  void hold();
  void follow_path(const PathSource& path);
  void pace_simulated();
  bool measurable() const;
  void find_profile();
  void run_as_wanted();
  void load_settings();
  void keep_settings();
  std::filesystem::path settings_file() const;
  std::filesystem::path model_settings_file() const;

  std::filesystem::path folder_;
  std::vector<DeviceProfile> profiles_;
  HotplugMonitor watch_;
  Session* session_ = nullptr;
  ServoSettings of_scene_;  ///< the loop's, as the session brought them
  bool chosen_ = false;
  InputSource source_;
  std::shared_ptr<InputDevice> input_;  ///< of a connected device
  std::optional<std::string> named_;    ///< whose profile was looked for; none: not yet
  std::optional<DeviceProfile> profile_;
  DeviceSettings settings_;
  SimulatedGrip grip_ = chosen_grip();
  bool from_scene_ = false;
  bool measuring_ = false;
  std::filesystem::path damaged_;  ///< the file of settings, where it cannot be read
  QTimer keep_timer_;
  bool keeping_failed_ = false;
  QElapsedTimer clock_;
  qint64 counted_at_ = 0;
  std::uint64_t counted_ = 0;
  double reports_per_s_ = 0;
};

}  // namespace sonde::ui
