// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/haptics/safety/force_gate.hpp"

namespace sonde {

/// For a hand that is being measured: the wrench that it requests from the loop in one tick,
/// instead of the contact's wrench, and the loop's answer.
struct HandTrial {
  Wrench wrench;          ///< on the handle, about its point, in the device's base
  double max_force = 0;   ///< N, limit of the wrench
  double max_torque = 0;  ///< N·m, likewise
  // Motion of the handle since the last sample, in the device's base.
  Vec3 way = Vec3::Zero();   ///< m
  Vec3 turn = Vec3::Zero();  ///< rad, a rotation vector
  /// Why the wrench was withheld: set by the loop before it renders.
  Withheld withheld = Withheld::nothing;
};

}  // namespace sonde
