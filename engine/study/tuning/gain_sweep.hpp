// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/study/stability/contact_situations.hpp"
#include "engine/study/stability/rest.hpp"
#include "engine/study/stability/stiffness_sweep.hpp"

namespace sonde {

/// A contact with the hand that presses into it.
struct TuningSituation {
  ContactSituation contact;
  Wrench push;
  double theory = 0;  ///< stiffness up to which theory predicts stability in a light hand, N/m
};

/// The ratios of the classic coupling's rotational gains to its translational ones if all are swept
/// together: k_r/k_t and b_r/b_t, m².
struct JointGains {
  double stiffness = 0;
  double damping = 0;
};

/// Gains of the damped coupling that theory of a handle that no hand holds, the driver and the
/// encoder allow.
struct DamperInTheory {
  double stiffness = 0, damping = 0;  ///< N/m, N·s/m
};

/// Sets the gains of an axis; if both springs are swept, k_r from k_t, and a damper that is not
/// swept to zero.
void set_gains(Coupling& coupling, GainAxis axis, double stiffness, double damping,
               const JointGains& joint);

/// One situation of a study, with one device and one hand.
struct TuningSetup {
  ClosedLoopSetup loop;
  TuningSituation situation = {};
  double low = 1, high = 1e5;  ///< stiffness, N/m
  double ratio = 1.02;
  double rotation_per_translation =
      1;  ///< m²: factor from the translational to the rotational range
  JointGains joint = {};
  double most_damping = 0;             ///< virtual, N·s/m
  double most_rotational_damping = 0;  ///< N·m·s/rad
  double most_object_damping = 0;      ///< N·s/m, of the object norm: what the loop would render
};

/// The recommended stiffness is below the least unstable one by this factor.
constexpr double stability_margin = 1.5;

/// Multiples of the usual knock that are tested too: friction may end the oscillation after a soft
/// knock but not after a hard one.
constexpr double harder_knocks[] = {2, 4};

/// What a sweep searches in addition to the limits of the setup itself.
struct SweepExtent {
  bool beyond = false;            ///< runs above the limits, for the map
  bool without_friction = false;  ///< the limit of stability of a device without friction
  bool harder_knocks = false;     ///< the same at harder_knocks, if it is lower
  /// N/m (N·m/rad): the stiffness at which the probe is held for seconds, to see whether it keeps
  /// oscillating without friction and after the hardest of harder_knocks; 0: none.
  double long_hold = 0;
  /// The share of the largest damping at which limits are known to the setup's ratio, with runs
  /// above them, and with the limits without friction and at harder knocks even if nothing is good.
  /// At other shares limits are known to `coarse_ratio`, without runs above them. Not given: all
  /// are known to the setup's ratio. If nothing is good, those two limits are not searched for,
  /// except at this share, since there is nothing to limit.
  std::optional<double> in_full = {};
};
/// The fifth power of a sweep's ratio, at most 2: with a ratio of 1.02, the holding stiffness is at
/// most a tenth below the limit.
double coarse_ratio(double ratio);

/// The push with its knock, without a jolt.
Press press_of(const TuningSituation& situation);
/// The push of a sweep over the stiffness of an axis. If rotations are swept, the knock also turns
/// the probe, about the axis of largest resistance.
Press press_of(const TuningSetup& setup, GainAxis axis);

/// Gains well within the theoretical limit: half of it, without damping. Gains that a sweep does
/// not change keep these values.
void set_base_gains(TuningSetup& setup);

/// The stiffness of one axis up to which theory predicts stability and passivity of the linear
/// contact, at `share` of the largest damping: N/m | N·m/rad. Infinite if theory has no limit.
struct TheoryLimits {
  double stable = 0;
  double released = 0;  ///< no buzz without a hand on the handle (largest_released_factor)
  double released_any_swing = 0;      ///< the same of any frequency: stable without a hand
  double passive = 0;                 ///< 0: at no stiffness (largest_passive_factor)
  double passive_in_translation = 0;  ///< the same with the turn held
  double cycle_lever = 0;             ///< cycle_lever at 1 N/m | 1 N·m/rad of the axis
};
TheoryLimits theory_limits(const TuningSetup& setup, GainAxis axis, double share);

/// A hold until the probe rests, with a knock of this multiple of the usual strength.
RestReport hold_until_rest(const TuningSetup& setup, GainAxis axis, double stiffness,
                           double damping, double knock);

/// The largest damping of an axis, N·s/m | N·m·s/rad; 0 if it has none.
double most_damping(const TuningSetup& setup, GainAxis axis);

/// The shares of the largest damping at which an axis is swept, evenly spaced by ratio: from one at
/// which it damps a spring as soft as a light hand with less than a tenth of the critical damping;
/// also zero, and only zero if the axis has no damping. Without zero if only one damper is swept.
std::vector<double> damping_shares(const TuningSetup& setup, GainAxis axis);

/// Sweeps the stiffness of one axis at each share of the largest damping. JSON: {"columns":
/// [{damping, theory_stable, theory_passive, stable, good, ..., "runs": [...]}, ...]}.
std::string sweep_gains(const TuningSetup& setup, GainAxis axis, const std::vector<double>& shares,
                        const SweepExtent& extent, const Stop& stop);

}  // namespace sonde
