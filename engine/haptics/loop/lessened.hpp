// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/haptics/loop/hand_loop.hpp"

namespace sonde {

/// Why the force or the torque on the hand differs from the coupling's. If there are several
/// reasons, the one that determines the value now: for example, a force that is still rising is far
/// below its limit, whatever the coupling wants.
enum class Lessened {
  nothing,
  coming_in,  ///< it rises from zero after a start or a fault (SafetySettings::ramp_time)
  fading,     ///< the separated pose has not settled (Withheld::unsettled)
  slewed,     ///< it is at its largest rate of change
  limited,    ///< it is at the largest value that the coupling allows (max_force, max_torque)
};

Lessened force_lessened(const Wrench& given, const HandState& hand, const Coupling& coupling);
Lessened torque_lessened(const Wrench& given, const HandState& hand, const Coupling& coupling);
/// A few words for the window; "" for nothing.
const char* words(Lessened by);

}  // namespace sonde
