// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <future>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "engine/devices/device_settings.hpp"
#include "engine/devices/input_device.hpp"
#include "engine/haptics/hand/awaited_hand.hpp"
#include "engine/haptics/hand/hand_switch.hpp"
#include "engine/haptics/hand/simulated_device.hpp"
#include "engine/haptics/loop/background_search.hpp"
#include "engine/haptics/loop/clearance_gauge.hpp"
#include "engine/haptics/loop/servo.hpp"
#include "ui/document/loaded_scene.hpp"

namespace sonde::ui {

/// What is open: two bodies, the servo that runs on them, the hand that holds the probe, and the
/// gains. Made in a worker thread (the start may search) and then used from the window's thread
/// alone.
class Session {
 public:
  /// The mouse holds the probe.
  explicit Session(LoadedScene loaded);
  ~Session();

  const LoadedScene& loaded() const { return loaded_; }
  const Body& probe() const { return loaded_.pair.probe(); }
  const Body& fixed() const { return loaded_.pair.fixed(); }

  /// The newest snapshot, valid until the next call; null before the first tick.
  const Snapshot* latest() { return placing() ? nullptr : servo_.latest(); }

  /// The deadlines so far, valid until the next call.
  const ServoTiming& timing() { return placing() ? no_timing_ : servo_.timing(); }

  /// Every tick in its order; false where there is none left. See Servo::next_tick.
  bool next_tick(Snapshot& out) { return !placing() && servo_.next_tick(out); }

  /// Of those, how many were dropped because they were fetched too late.
  std::uint64_t ticks_dropped() const { return servo_.ticks_dropped(); }

  /// What holds the probe from now on; it takes over where the probe is, so that nothing jumps.
  void hold_by_mouse();
  /// A simulated device, in a hand that goes where the mouse wants the probe. Throws
  /// std::invalid_argument where such a device cannot be simulated at this rate.
  void hold_by(const SimulatedDeviceParameters& device, double scaling);
  void hold_by(std::shared_ptr<InputDevice> device, const DeviceSettings& settings);
  /// Any other hand.
  void hold_by(std::shared_ptr<const Hand> hand);
  /// A recorded path, from its beginning; not an empty one.
  void replay(std::vector<TimedPose> path);
  void set_device_settings(const DeviceSettings& settings);
  /// What is known of the handle of a connected device; none: nothing. See DeviceMotion.
  void set_device_profile(const std::optional<DeviceTraits>& at_handle);
  /// The axes of the picture, for devices that go by them: x right, y up, z to the eye.
  void set_view(const Quat& q_FV);
  /// A button of the device holds the clutch open: the probe stays.
  bool clutch_open() const;
  /// Lets go of hands that were replaced. To be called now and then.
  void sweep() { hands_.sweep(); }

  /// Where the probe is wanted: by the mouse, or else where the device has it. X_FM.
  Pose device_pose();
  /// A simulated device that holds the probe has other parameters from the next tick on, and goes
  /// on as it moves. Throws as hold_by; then all stays.
  void set_simulated(const SimulatedDeviceParameters& device);
  /// By the mouse. Nothing, where something else holds the probe.
  void set_device_pose(const Pose& X_FM);

  /// From the next tick on. loaded().servo says what runs now. A simulated device is made for one
  /// rate: pace_simulated() takes it to the one that runs now, with its hand and its push. Throws
  /// std::invalid_argument where it cannot run at that; then it is as it was.
  void set_rate(double rate_hz);
  void pace_simulated();
  void set_passivity_control(bool on);
  /// Whether ticks, and the search beside them, say where their time went; off at first.
  void set_time_phases(bool on) {
    servo_.set_time_phases(on);
    searched_.set_time_phases(on);
  }
  /// The share of the searches beside the ticks that should keep to their claim; 0.9 at first.
  void set_sure(double share) { searched_.set_sure(share); }
  /// The time of a tick, or its wanted accuracy, as these say; loaded().servo has them then.
  void set_knob(const ServoSettings& servo);

  const Coupling& coupling() const { return coupling_; }
  void set_coupling(const Coupling& coupling);

  /// False: no force on the hand from the next tick on, whatever the contact.
  bool force_on() const { return force_on_; }
  void set_force(bool on);

  bool paused() const { return paused_; }
  void set_paused(bool paused);

  /// The probe goes back to its start; see place(). What was searched there the first time is not
  /// searched again.
  void reset() { place(loaded_.start); }
  /// The probe goes to that pose at once, and the servo starts afresh there: following it on a path
  /// swept free could leave the separated pose behind an obstacle. Where it overlaps there, a
  /// search comes first, in a thread of its own: until it has ended there is no snapshot, and the
  /// hand gets nothing. Of several places the newest counts.
  void place(const Pose& X_FM);
  /// Is it on its way there?
  bool placing();
  /// The last call of this thread but stop_force(): what is left to do can take a while, and is
  /// done in another thread by end(), with which a pressed hand's force falls gradually.
  void let_go();
  void end();
  /// No force any more on a hand that is let go.
  void stop_force() { servo_.set_force(false); }
  /// True once nothing here asks a device any more.
  LoopEnded ended() const { return ended_; }
  /// A device holds the probe once these have ended: sessions that had it before.
  void wait_for(std::vector<LoopEnded> others) { others_ = std::move(others); }
  /// Where reset() leads from now on.
  void set_start(const Pose& X_FM) { loaded_.start = X_FM; }

  /// PD_t and the lower bound, in a thread of their own: computed only when asked for. `known`: a
  /// separated pose of it that is known.
  void ask_search(const Pose& X_FM, const std::optional<Pose>& known) {
    searched_.request(X_FM, known);
  }
  std::optional<BackgroundResult> searched() { return searched_.latest(); }
  /// See ClearanceGauge::at: a few milliseconds at most, in a thread of its own.
  std::optional<GaugedClearance> clearance(const Pose& X_FM);

 private:
  struct Holding;
  void begin(const Pose& X_FM);
  void hold(std::shared_ptr<Holding> holding);
  Pose probe_pose();

  LoadedScene loaded_;
  Pose target_;                  ///< X_FM where the mouse wants the probe
  std::vector<TimedPose> path_;  ///< the last one replayed
  Quat q_FV_ = Quat::Identity();
  Coupling coupling_;
  bool force_on_ = true;
  bool paused_ = false;
  BackgroundSearch searched_;
  ClearanceGauge gauge_;
  std::shared_ptr<Holding> holding_;
  HandSwitch hands_;
  Servo servo_;
  const ServoTiming no_timing_{};
  std::optional<Pose> wanted_;     ///< X_FM, where to begin once what is searched now has ended
  std::future<void> beginning_;    ///< the servo is no other thread's meanwhile
  std::atomic<bool> begun_{true};  ///< it has left the hand as it was before
  const std::shared_ptr<std::atomic<bool>> ended_ = std::make_shared<std::atomic<bool>>(false);
  std::vector<LoopEnded> others_;
};

}  // namespace sonde::ui
