// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/haptics/loop/hand_loop.hpp"

namespace sonde {

/// What makes the force or the torque on the hand another than the coupling wants, where several do
/// that one which holds it now: a force that comes in is far below its limit, whatever is asked.
enum class Lessened {
  nothing,
  coming_in,  ///< it rises from zero after a start or a fault (SafetySettings::ramp_time)
  fading,     ///< the separated pose has not settled (Withheld::unsettled)
  slewed,     ///< it changes no faster than its slew limit
  limited,    ///< it is at the largest that the coupling allows (max_force, max_torque)
};

Lessened force_lessened(const Wrench& given, const HandState& hand, const Coupling& coupling);
Lessened torque_lessened(const Wrench& given, const HandState& hand, const Coupling& coupling);
/// A few words for the window; "" for nothing.
const char* words(Lessened by);

}  // namespace sonde
