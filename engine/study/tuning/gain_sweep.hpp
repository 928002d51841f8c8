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
  double theory = 0;  ///< stiffness up to which the linear contact is stable in a light hand, N/m
};

/// The ratios of the classic coupling's rotational gains to its translational ones where all are
/// swept together: k_r/k_t and b_r/b_t, m².
struct JointGains {
  double stiffness = 0;
  double damping = 0;
};

/// Sets the gains of an axis; where both springs are swept, k_r by k_t, and a damper that is not
/// swept to none.
void set_gains(Coupling& coupling, GainAxis axis, double stiffness, double damping,
               const JointGains& joint);

/// One situation of a study, with one device and one hand.
struct TuningSetup {
  ClosedLoopSetup loop;
  TuningSituation situation = {};
  double low = 1, high = 1e5;  ///< stiffness, N/m
  double ratio = 1.02;
  double rotation_per_translation =
      1;  ///< m²: what makes a rotational range of a translational one
  JointGains joint = {};
  double most_damping = 0;             ///< virtual, N·s/m
  double most_rotational_damping = 0;  ///< N·m·s/rad
};

/// The recommended stiffness is this much below the least at which a hold is not stable.
constexpr double stability_margin = 1.5;

/// So many times as hard the hand also knocks: what friction ends at a soft knock it may not end at
/// a hard one.
constexpr double harder_knocks[] = {2, 4};

/// What a sweep searches beside the limits of the setup as it is.
struct SweepExtent {
  bool beyond = false;            ///< runs above the limits, for the map
  bool without_friction = false;  ///< the limit of stability of a device without friction
  bool harder_knocks = false;     ///< that at harder_knocks, where it is lower
  /// N/m (N·m/rad): whether the probe swings on at this stiffness for seconds, without friction and
  /// after the hardest of harder_knocks, is looked at in full; 0: it is not.
  double long_hold = 0;
  /// The share of the largest damping whose limits are known to the setup's ratio, with runs above
  /// them, and with the limits without friction and at harder knocks even where nothing is good.
  /// At others limits are known to `coarse_ratio`, and nothing is run above them. Not given: each
  /// is known to the setup's ratio. Where nothing is good those two are not searched for, unless in
  /// full: there is nothing to cap.
  std::optional<double> in_full = {};
};
/// The fifth power of a sweep's ratio, at most 2: what holds is at most a tenth below the limit
/// where the ratio is 1.02.
double coarse_ratio(double ratio);

/// The push alone, with its knock.
Press press_of(const TuningSituation& situation);
/// The push of a sweep over the stiffness of an axis. Where rotations are swept, the knock also
/// turns the probe, about the axis that resists most.
Press press_of(const TuningSetup& setup, GainAxis axis);

/// Gains well within what theory allows: half of it, without damping. Gains that a sweep does not
/// change stay there.
void set_base_gains(TuningSetup& setup);

/// The stiffness of one axis up to which theory has the linear contact stable and passive, at
/// `share` of the largest damping: N/m | N·m/rad. Infinite where theory sees no end.
struct TheoryLimits {
  double stable = 0;
  double released = 0;  ///< stable where no hand holds the handle (largest_released_factor)
  double passive = 0;   ///< 0: at no stiffness (largest_passive_factor)
  double passive_in_translation = 0;  ///< the same with the turn held
  double cycle_lever = 0;             ///< cycle_lever at 1 N/m | 1 N·m/rad of the axis
};
TheoryLimits theory_limits(const TuningSetup& setup, GainAxis axis, double share);

/// A hold until the probe rests, at a knock of so many times the usual.
RestReport hold_until_rest(const TuningSetup& setup, GainAxis axis, double stiffness,
                           double damping, double knock);

/// The largest damping of an axis, N·s/m | N·m·s/rad; 0 where it has none.
double most_damping(const TuningSetup& setup, GainAxis axis);

/// The shares of the largest damping at which an axis is swept, evenly spaced by ratio: from one at
/// which it damps a spring as soft as a light hand with less than a tenth of the critical damping;
/// zero too, and only that where it has none. Without zero where one damper alone is swept.
std::vector<double> damping_shares(const TuningSetup& setup, GainAxis axis);

/// Sweeps the stiffness of one axis at each share of the largest damping. JSON: {"columns":
/// [{damping, theory_stable, theory_passive, stable, good, ..., "runs": [...]}, ...]}.
std::string sweep_gains(const TuningSetup& setup, GainAxis axis, const std::vector<double>& shares,
                        const SweepExtent& extent, const Stop& stop);

}  // namespace sonde
