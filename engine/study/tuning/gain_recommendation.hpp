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
  /// "rest" (above it the probe swings on somewhere: RestLadder), "released" (theory, of a handle
  /// that no hand holds), "stability", "saturation", "chatter", "fidelity" (measured), "friction"
  /// (stability without it), "knocks" (stability at harder_knocks), "driver" (the profile's largest
  /// stiffness), "resolution" (a step of the encoder), "range" (nothing within the range studied).
  std::string reason;
  double stiffness = 0;
  std::string kind, hand;  ///< of the situation where that is; empty where it is no measurement
};

/// The recommended stiffness (and damping) of one axis.
struct AxisGains {
  GainAxis axis = GainAxis::object;
  double stiffness = 0;  ///< N/m | N·m/rad; 0: none in the range studied is good
  double damping = 0;    ///< N·s/m | N·m·s/rad
  /// The least stiffness, over situations and hands, that is not stable; infinite where all that
  /// was studied is.
  double boundary = 0;
  /// The same on a device without friction, and at harder_knocks; infinite also where the study did
  /// not search for them.
  double without_friction = 0, harder_knocks = 0;
  bool without_friction_by_theory = false;  ///< as TuningColumn, where that is
  /// At this stiffness the probe was held for seconds (LongHold): what the first look recommends,
  /// over all contacts; 0 where it was not held so, at this damping.
  double held_at = 0;
  /// Where it swings on then without friction, so that the gains may rely on it, and after the
  /// hardest of harder_knocks; with the limit of theory.
  std::vector<GainLimit> swings_without_friction, swings_at_harder_knocks;
  double passive = 0;  ///< up to which theory has every situation passive; 0: at no stiffness
  double passive_in_translation = 0;  ///< the same with the turn of the handle held
  double cycle_lever = 0;             ///< the largest of cycle_lever, at one N/m | N·m/rad
  double released = 0;                ///< up to which theory has a handle stable that no hand holds
  bool tried = false;           ///< on the ladder (RestLadder): only what rests is recommended
  double longest_to_rest = 0;   ///< s, there
  std::optional<Swing> swings;  ///< what went on at the next rung above, or at the lowest
  double theory = 0;            ///< up to which theory has every situation stable, without friction
  GainLimit limit;              ///< the one that holds: its stiffness is the recommended one
  std::vector<GainLimit> limits;  ///< the least of each reason, the lowest first

  double margin() const { return stiffness > 0 ? boundary / stiffness : 0; }
};

/// The gains of the classic coupling that these are; of the object norm, its k.
Coupling coupling_of(const AxisGains& gains, const JointGains& joint);

/// ζ of the handle held by the springs alone, its own damping and the virtual one together; no
/// value where there is no such spring.
struct DampingRatios {
  std::optional<double> translation, rotation;
};
DampingRatios damping_ratios(const TuningResults& results, const AxisGains& gains);

/// From the lines of one axis. Where the study has a ladder of it, the damping is the ladder's, and
/// the stiffness the largest rung below the least limit that everything came to rest on. With
/// `assumed`, from those for a profile value at `times` itself alone, which are of one situation;
/// no value where there is none.
std::optional<AxisGains> recommend(const TuningResults& results, GainAxis axis,
                                   const std::string& assumed = {}, double times = 1);
/// The gains of the lines of one axis at each damping that was swept, the least damping first.
std::vector<AxisGains> recommend_at_each_damping(const TuningResults& results, GainAxis axis);
/// Of all dampings swept beside these gains, with both dampers or one, that which allows most.
std::optional<AxisGains> best_damped(const TuningResults& results, const AxisGains& gains);
/// The gains from only the situation and hand in which the assumed values are varied, at their
/// damping: the reference for these.
std::optional<AxisGains> recommend_as_varied(const TuningResults& results, GainAxis axis);

/// At one damping, from the lines of each hand alone: how the hand holds is an assumption too.
std::map<std::string, AxisGains> recommend_by_hand(const TuningResults& results, GainAxis axis,
                                                   double damping);

/// Held for seconds at another stiffness than the recommended one: further away than a first look
/// can be, as where contacts of one kind alone are studied.
bool held_elsewhere(const AxisGains& gains);
/// What is recommended relies on friction only where that is asked for.
bool trusts_friction(const TuningResults& results);

/// The axes studied.
std::vector<GainAxis> axes_of(const TuningResults& results);
/// The springs of the classic coupling with both dampers, and with each by itself; the one of them
/// that is recommended is first.
std::vector<GainAxis> joint_axes(const TuningResults& results);
/// Of axes_of those whose gains are recommended: the first of joint_axes, where there is any.
std::vector<GainAxis> recommended_axes(const TuningResults& results);

/// True where some stiffness is good on each axis that is recommended.
bool has_recommendation(const TuningResults& results);
/// The gains as a coupling of a scene, within the range of its settings.
Coupling recommended_coupling(const TuningResults& results);

}  // namespace sonde
