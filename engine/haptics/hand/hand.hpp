// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "engine/geometry/pose.hpp"
#include "engine/haptics/coupling/coupling.hpp"
#include "engine/haptics/hand/device_traits.hpp"

namespace sonde {

struct HandTrial;

/// The input of the hand in one tick.
struct HandSample {
  Pose X_FM;             ///< the probe's mesh frame in the fixed body's
  bool held = true;      ///< false: the clutch is open; the probe stays, and there is no force
  bool trusted = true;   ///< false: the pose is old or impossible; there is no force
  bool changed = false;  ///< another hand, or the same with new axes: no force in this tick
  /// Ratio of the device's new scaling to the old one: from this sample on, the same motion of the
  /// hand moves the probe this many times as far as before. Nothing else has changed. 1: no change.
  double rescaled = 1;
  std::optional<DeviceTraits> device = {};  ///< none: unknown device
  /// For a hand that is being measured, valid until its next sample: the loop renders this instead
  /// of the contact's wrench. Null for every other hand.
  HandTrial* trial = nullptr;
  /// s: time from the device's previous report to the report of this pose; 0: no longer than a
  /// tick.
  double since = 0;
};

/// The source of the probe's pose and the receiver of the force: a mouse, a device, a simulated
/// one, or a recorded path. All functions are called on the servo thread only, once in each tick
/// and in this order, and none allocates, locks, logs, throws or waits. When the servo stops,
/// render gets a zero wrench once more, even if there was no tick.
struct Hand {
  /// dt: s since the last sample; 0 for the first.
  std::function<HandSample(double dt)> sample;
  /// Receives the wrench on the hand, about the probe's centre of mass at the sampled pose, in the
  /// fixed frame, after every limit. May be empty.
  std::function<void(const Wrench&)> render;
  /// Receives how far the loop is behind the probe (HandLoop::behind). A hand that is nobody's may
  /// wait for it. May be empty.
  std::function<void(double behind)> follow = {};
};

}  // namespace sonde
