// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "engine/geometry/chart.hpp"
#include "engine/haptics/hand/hand.hpp"
#include "engine/study/stability/closed_loop.hpp"

namespace sonde {

/// What buzzes lies between these, Hz: no hand moves so fast by itself, and skin feels it best.
constexpr double slowest_chatter = 20;
constexpr double fastest_chatter = 500;
/// So much of the end of what is given decides, s: six swings of the slowest.
constexpr double chatter_window = 0.3;
/// m/s², root mean square: what the most sensitive feel of a handle that vibrates, 0.01 µm at 200
/// Hz (Brisben, Hsiao and Johnson, 1999); most people, and other frequencies, take more.
constexpr double felt_acceleration = 0.01;

/// One tick: where the handle was, and what the motors gave it.
struct FeltTick {
  Vec6
      place;  ///< of the probe's centre of mass, m, and a rotation vector, rad, from any fixed pose
  Vec6 wrench;  ///< N, N·m, on the hand
};

/// The handle as the force meets it, at the probe.
struct FeltHandle {
  struct Range {
    double least = 0, most = 0;
  };
  Range mass;      ///< kg
  Range inertia;   ///< kg·m²
  double lag = 0;  ///< s from a tick's place to the middle of the time that its wrench acts
};

/// A mass that is known, of which profiles are sure to a half at best.
FeltHandle felt_handle(double mass, double inertia, double lag);
/// As a device tells it; of one that does not, from 20 g to 2 kg and from 5 to 5000 kg·mm².
FeltHandle felt_handle(const DeviceTraits& device, double sample_time);

/// Of a study: the true state of the handle after a tick, and what the motors gave during it.
FeltTick felt_tick(const HandleState& state, const Wrench& motors, const Pose& from);
FeltHandle felt_handle(const ClosedLoopSetup& setup);

/// An oscillation that the loop makes.
struct Chatter {
  double force = 0;      ///< N, amplitude throughout the window; of torques, over `length`. 0: none
  double frequency = 0;  ///< Hz
  double acceleration = 0;  ///< m/s², root mean square, of the handle; of turns, times `length`
  bool buzzes() const { return acceleration >= felt_acceleration; }
};

/// Whether the loop makes the handle swing, told apart from what a hand or a mouse does. Both move
/// the probe, and the force follows; only in a loop does the force move the handle. So of what
/// swings most between 20 and 500 Hz, the handle must obey Newton's law with a hand that only
/// yields,
///
///     F = (k_h + jωb − mω²) x,   0 ≤ k_h ≤ |F|/|x|,   b > 0,
///
/// with F the motors' own force and m the handle's mass: then nobody else need push, and the motors
/// feed the swing. What a hand, a mouse or a path makes of the same size and frequency needs
/// another mass. Besides, force and handle are coherent, and the swing is there from the first to
/// the last of five parts of the window and does not die down: a knock, a step, a contact that
/// comes or goes rings and is over. Translation and rotation are looked at each by itself; the
/// result is the one that is felt more. The steady force does not count. Nothing where there are
/// too few ticks. Allocates.
Chatter chatter(std::span<const FeltTick> ticks, double sample_time, const FeltHandle& handle,
                double length);

}  // namespace sonde
