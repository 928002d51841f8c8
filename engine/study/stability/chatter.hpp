// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "engine/geometry/chart.hpp"
#include "engine/haptics/hand/hand.hpp"
#include "engine/study/stability/closed_loop.hpp"

namespace sonde {

/// The range of frequencies of a buzz, Hz: no hand moves this fast by itself, and skin is most
/// sensitive to it.
constexpr double slowest_chatter = 20;
constexpr double fastest_chatter = 500;
/// s: length of the window at the end of the data that decides: six periods of the slowest buzz.
constexpr double chatter_window = 0.3;
/// m/s², root mean square: threshold of the most sensitive people for a vibrating handle, 0.01 µm
/// at 200 Hz (Brisben, Hsiao and Johnson, 1999); most people, and other frequencies, need more.
constexpr double felt_acceleration = 0.01;

/// One tick: the position of the handle, and the output of the motors.
struct FeltTick {
  Vec6
      place;  ///< of the probe's centre of mass, m, and a rotation vector, rad, from any fixed pose
  Vec6 wrench;  ///< N, N·m, on the hand
};

/// The handle that the force acts on, at the probe.
struct FeltHandle {
  struct Range {
    double least = 0, most = 0;
  };
  Range mass;      ///< kg
  Range inertia;   ///< kg·m²
  double lag = 0;  ///< s from a tick's position sample to the middle of the interval in which its
                   ///< wrench acts
};

/// For a known mass, whose value in profiles is certain only to within a half.
FeltHandle felt_handle(double mass, double inertia, double lag);
/// As reported by a device; if it reports none, from 20 g to 2 kg and from 5 to 5000 kg·mm².
FeltHandle felt_handle(const DeviceTraits& device, double sample_time);

/// In a study: the true state of the handle after a tick, and the output of the motors during it.
FeltTick felt_tick(const HandleState& state, const Wrench& motors, const Pose& from);
FeltHandle felt_handle(const ClosedLoopSetup& setup);

/// An oscillation caused by the loop.
struct Chatter {
  double force = 0;      ///< N, amplitude throughout the window; of torques, over `length`. 0: none
  double frequency = 0;  ///< Hz
  double acceleration = 0;  ///< m/s², root mean square, of the handle; of turns, times `length`
  bool buzzes() const { return acceleration >= felt_acceleration; }
};

/// Detects whether the loop makes the handle oscillate, as opposed to a hand or a mouse. Both move
/// the probe, and the force follows; only in a loop does the force move the handle. So for the
/// largest oscillation between 20 and 500 Hz, the handle must obey Newton's law with a passive
/// hand,
///
///     F = (k_h + jωb − mω²) x,   0 ≤ k_h ≤ |F|/|x|,   b > 0,
///
/// with F the motors' force and m the handle's mass: then nobody else needs to push, and the motors
/// feed the oscillation. The same motion made by a hand, a mouse or a path would need another mass.
/// In addition, force and handle must be coherent, and the oscillation must be present in all of
/// five parts of the window and not decay: the vibration after a knock, a step, or a contact that
/// begins or ends is soon over. And where the position is seen to be read in steps, its oscillation
/// must be half a step or more: the saw teeth of a slow glide are smaller, and so is what a tremor
/// leaves between the readings. Reports that a device missed now and then are no such steps.
/// Translation and rotation are examined separately; the result is the one that is felt more. The
/// steady force does not count. Returns no oscillation if there are too few ticks. Allocates.
Chatter chatter(std::span<const FeltTick> ticks, double sample_time, const FeltHandle& handle,
                double length);

}  // namespace sonde
