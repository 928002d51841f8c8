// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/haptics/safety/force_gate.hpp"

namespace sonde {

/// What a hand that is being measured asks of the loop in one tick, in place of the contact's
/// wrench; and what the loop answers.
struct HandTrial {
  Wrench wrench;          ///< on the handle, about its point, in the device's base
  double max_force = 0;   ///< N, what the wrench is limited to
  double max_torque = 0;  ///< N·m, the same
  // How the handle moved since the sample before, in the device's base.
  Vec3 way = Vec3::Zero();   ///< m
  Vec3 turn = Vec3::Zero();  ///< rad, a rotation vector
  /// Why it got no wrench: set by the loop before it renders.
  Withheld withheld = Withheld::nothing;
};

}  // namespace sonde
