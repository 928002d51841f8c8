// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/study/stability/press_and_hold.hpp"

namespace sonde {

/// Whether a probe that a hand has pressed into a contact and knocked comes to rest. At rest: over
/// a window (Press::window_time) the handle's mean kinetic energy is below quiet_energy, and not
/// above that of the window before, unless both are below a hundredth of it.
struct RestReport {
  bool at_rest = false;
  double time = 0;     ///< s from the knock's end until rest, or until the hold was given up
  double kinetic = 0;  ///< J, mean over the last window
  double swing = 0;    ///< m, half of the range in that window of the coordinate that moves most:
                     ///< of the centre of mass, or of a turn times the handle's radius of gyration
  double frequency = 0;  ///< Hz, of that coordinate
  int failures = 0;      ///< ticks without an answer; with any, it is not at rest
};

/// The maximum time of a hold.
struct RestPatience {
  double fades = 60;  ///< s, if its energy falls steadily
  double lasts = 3;   ///< s, if not: it has not fallen by a tenth in a second and a half
};

RestReport press_until_rest(ClosedLoop& loop, const Press& press,
                            const RestPatience& patience = {});

}  // namespace sonde
