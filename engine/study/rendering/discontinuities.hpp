// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/study/rendering/rendering.hpp"

namespace sonde {

/// The discontinuities of a rendering. Let s be the distance √σ that the device moved in a tick, k
/// the stiffness and R the probe's radius:
///
/// - A *jump* is reported by the engine: the depth fell by more than s, so the contact moved to
///   another place.
/// - A *force step* is a change of force above k (2s + c): from one tick to the next the separated
///   pose moved further than the device. c is the slack of the solver in two poses, twice its
///   clearance.
/// - A *torque step* is a change of torque above R times that.
/// - A *pop-through* is a jump by the depths alone, after which the force is gone or points the
///   other way (F·F′ ≤ 0): the probe came out on another side.
///
/// The first tick, and ticks without an answer or after one, are not counted.
struct Discontinuities {
  int jumps = 0;
  int force_steps = 0;
  int torque_steps = 0;
  int pop_throughs = 0;
  double largest_force_step = 0;   ///< N from one tick to the next, whether it counts or not
  double largest_torque_step = 0;  ///< N·m
};

/// k in N/m, radius in m. With damping, changes of velocity count as steps too.
Discontinuities discontinuities(const Rendering& rendering, double k, double radius);

/// Whether the probe popped through between two successive ticks.
bool popped_through(const RenderedTick& before, const RenderedTick& now, double radius);

}  // namespace sonde
