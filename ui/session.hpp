// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "engine/haptics/companion.hpp"
#include "engine/haptics/servo.hpp"
#include "ui/opening.hpp"

namespace sonde::ui {

/// What is open: two bodies, the servo that runs on them, and the gains. Made in a worker thread
/// (the start may search) and then used from the window's thread alone.
class Session {
 public:
  explicit Session(Opened opened);

  const Opened& opened() const { return opened_; }
  const Body& probe() const { return *opened_.probe; }
  const Body& fixed() const { return *opened_.fixed; }

  /// The newest snapshot, valid until the next call; null before the first tick.
  const Snapshot* latest() { return servo_.latest(); }

  /// Where the window holds the probe: X_FM.
  const Pose& device_pose() const { return device_; }
  void set_device_pose(const Pose& X_FM);

  const Coupling& coupling() const { return coupling_; }
  void set_coupling(const Coupling& coupling);

  bool paused() const { return paused_; }
  void set_paused(bool paused);

  /// The probe goes back to its first pose, and the servo starts afresh there: following it on a
  /// path swept free could leave the separated pose behind an obstacle.
  void reset();

  /// PD_t and the lower bound, in a thread of their own: computed only when asked for.
  void ask_companion(const Pose& X_FM) { companion_.request(X_FM); }
  std::optional<CompanionResult> companion() { return companion_.latest(); }

 private:
  Opened opened_;
  Pose device_;
  Coupling coupling_;
  bool paused_ = false;
  Companion companion_;
  Servo servo_;
};

}  // namespace sonde::ui
