// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/study/tuning/tuning.hpp"

namespace sonde {

/// A hold that did not come to rest.
struct Swing {
  std::string kind, hand;
  double friction = 1;       ///< times the profile's
  double knock = 1;          ///< times the usual
  double amplitude = 0;      ///< m, as RestReport::swing; 0 if the solver gave no answer
  double frequency = 0;      ///< Hz
  double theory_stable = 0;  ///< N/m, of the contact in that hand
};

/// One stiffness at which everything that a recommendation promises was tested.
struct Rung {
  double stiffness = 0;        ///< N/m
  std::optional<Swing> swing;  ///< the first hold that did not come to rest; none: all did
  double longest = 0;          ///< s, until the slowest did
};

/// Gains tried for what they are recommended for, from above the first look's result (but no
/// higher than TuningPlan::unmeasured, above which nothing is recommended) downwards: every
/// contact, held by the study's hands and by a limp one, with the profile's friction and (unless
/// that is trusted) without any, after knocks of 1, 2 and 4 times the usual strength.
struct RestLadder {
  GainAxis axis = GainAxis::object;
  double damping = 0;
  std::vector<Rung> rungs;  ///< the stiffest first

  /// The stiffest rung, not above `stiffness`, at which all came to rest; null if there is none.
  const Rung* held(double stiffness) const;
  /// The softest rung above `over`, and not above `stiffness`, at which some hold kept oscillating.
  const Rung* failed(double over, double stiffness) const;
};

/// A hand that barely holds: two finger tips.
constexpr HandGrip limp_hand{"limp", 50, 0.2};

/// A situation of the plan in such a hand. A hand softer than the light one pushes proportionally
/// less, with the same travel of its spring.
TuningSetup ladder_setup(const TuningPlan& plan, std::size_t situation, const HandGrip& hand);

/// Climbs down until everything comes to rest, and a little further; at most to 1/8 of the first
/// look. Where that ends above half of the first look, half of it is tried last: parts that are
/// still to come may allow less than what was held.
/// If the first look allows nothing, to 1/8 of what theory, the driver and the encoder allow,
/// wherever everything comes to rest, and at each of TuningPlan::dampings: the ladder is then that
/// of the one at which the stiffest came to rest. Throws Cancelled.
RestLadder climb_down(const TuningPlan& plan, const Stop& stop);

std::string to_json(const RestLadder& ladder);
/// Throws the parser's exceptions if the text is not a ladder.
RestLadder rest_ladder_of(const std::string& json);

}  // namespace sonde
