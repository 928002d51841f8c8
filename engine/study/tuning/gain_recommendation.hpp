// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/study/tuning/tuning_results.hpp"

namespace sonde {

/// A limit of the stiffness, and its reason.
struct GainLimit {
  /// "rest" (above it the probe keeps oscillating somewhere: RestLadder), "released" (theory, for a
  /// handle without a hand), "stability", "saturation", "chatter", "fidelity" (measured),
  /// "friction" (stability without friction), "knocks" (stability at harder_knocks), "driver" (the
  /// profile's largest stiffness, as felt in the contact), "rendered" (what the loop makes of
  /// stiffer gains, in any contact), "resolution" (a step of the encoder), "range" (no limit within
  /// the range studied).
  std::string reason;
  double stiffness = 0;
  std::string kind, hand;  ///< the situation of the limit; empty if it is no measurement
};

/// The recommended stiffness (and damping) of one axis.
struct AxisGains {
  GainAxis axis = GainAxis::object;
  double stiffness = 0;  ///< N/m | N·m/rad; 0: none in the range studied is good
  double damping = 0;    ///< N·s/m | N·m·s/rad
  /// The least stiffness, over situations and hands, that is not stable; infinite if all that were
  /// studied are.
  double boundary = 0;
  /// The same on a device without friction, and at harder_knocks; infinite also if the study did
  /// not search for them.
  double without_friction = 0, harder_knocks = 0;
  bool without_friction_by_theory = false;  ///< as in TuningColumn, for that limit
  /// The stiffness at which the probe was held for seconds (LongHold): the recommendation of the
  /// first look, over all contacts; 0 if it was not held at this damping.
  double held_at = 0;
  /// Where it then keeps oscillating without friction, so that the gains may rely on friction, and
  /// after the hardest of harder_knocks; with the theoretical limit.
  std::vector<GainLimit> swings_without_friction, swings_at_harder_knocks;
  /// Stiffness up to which theory predicts passivity in every situation; 0: at no stiffness.
  double passive = 0;
  double passive_in_translation = 0;  ///< the same with the turn of the handle held
  double cycle_lever = 0;             ///< the largest cycle_lever, at one N/m | N·m/rad
  /// Up to which theory predicts no buzz without a hand, and no growing swing of any frequency; no
  /// value for the latter if it is not known in every situation.
  double released = 0;
  std::optional<double> released_any_swing;
  bool tried = false;  ///< on the ladder (RestLadder): only gains at which all comes to rest
  double longest_to_rest = 0;   ///< s, at that rung
  std::optional<Swing> swings;  ///< the oscillation at the next rung above, or at the lowest
  /// Stiffness up to which theory predicts stability in every situation, without friction.
  double theory = 0;
  GainLimit limit;                ///< the deciding limit: its stiffness is the recommended one
  std::vector<GainLimit> limits;  ///< the least for each reason, the lowest first

  double margin() const { return stiffness > 0 ? boundary / stiffness : 0; }
};

/// What theory says of the handle at these gains if the hand lets go of it. A swing that grows is
/// unstable, however slow; a buzz is faster than slowest_buzz.
enum class LetGo { unknown, no_buzz, stable, slow_swing, buzz };
LetGo if_let_go(const AxisGains& gains);
/// The least of both limits; of one, if the other is not known.
double largest_if_let_go(const AxisGains& gains);

/// The gains as a classic coupling; for the object norm, its k.
Coupling coupling_of(const AxisGains& gains, const JointGains& joint);

/// Damping ratio ζ of the handle held by the springs alone, with its own and the virtual damping;
/// no value if there is no such spring.
struct DampingRatios {
  std::optional<double> translation, rotation;
};
DampingRatios damping_ratios(const TuningResults& results, const AxisGains& gains);

/// From the lines of one axis. If the study has a ladder for it, the damping is the ladder's, and
/// the stiffness the largest rung below the least limit at which everything came to rest. With
/// `assumed`, only from the lines for a profile value at `times` its value, which have one
/// situation; no value if there are none.
std::optional<AxisGains> recommend(const TuningResults& results, GainAxis axis,
                                   const std::string& assumed = {}, double times = 1);
/// The gains of the lines of one axis at each swept damping, the least damping first; with `kind`,
/// only from its contacts.
std::vector<AxisGains> recommend_at_each_damping(const TuningResults& results, GainAxis axis,
                                                 const std::string& kind = {});
/// What may be rendered at the swept damping nearest to `damping`, with the limit that decides:
/// with `kind`, in its contacts. Never stiffer than what is recommended for that axis. (Of the
/// axes, the recommended one alone was tried until it rests.) No value if the study has no such
/// line.
std::optional<GainLimit> allowed_at(const TuningResults& results, GainAxis axis, double damping,
                                    const std::string& kind = {});
/// The best of the other dampings, with both dampers or one: the one that allows the largest
/// stiffness.
std::optional<AxisGains> best_damped(const TuningResults& results, const AxisGains& gains);
/// The gains from only the situation and hand in which the assumed values are varied, at their
/// damping: the reference for these.
std::optional<AxisGains> recommend_as_varied(const TuningResults& results, GainAxis axis);

/// At one damping, from the lines of each hand alone: the grip of the hand is an assumption too.
std::map<std::string, AxisGains> recommend_by_hand(const TuningResults& results, GainAxis axis,
                                                   double damping);

/// The probe was held for seconds at a stiffness other than the recommended one, further away than
/// a first look can be; this happens if only contacts of one kind are studied.
bool held_elsewhere(const AxisGains& gains);
/// Whether the recommendation may rely on friction, which the user must request.
bool trusts_friction(const TuningResults& results);

/// The axes studied.
std::vector<GainAxis> axes_of(const TuningResults& results);
/// The springs of the classic coupling with both dampers, and with each alone; the recommended one
/// is first.
std::vector<GainAxis> joint_axes(const TuningResults& results);
/// Those of axes_of whose gains are recommended: the first of joint_axes, if there is one.
std::vector<GainAxis> recommended_axes(const TuningResults& results);

/// True if some stiffness is good on each recommended axis.
bool has_recommendation(const TuningResults& results);
/// The gains as a coupling of a scene, within the range of its settings.
Coupling recommended_coupling(const TuningResults& results);

}  // namespace sonde
