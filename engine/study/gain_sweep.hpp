// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "engine/study/contact_situations.hpp"
#include "engine/study/press_and_hold.hpp"
#include "engine/study/stiffness_sweep.hpp"

namespace sonde {

/// The gains that a sweep changes: the one k of the object norm, or k_t with b_t, or k_r with b_r.
enum class GainAxis { object, translation, rotation };
const char* name_of(GainAxis axis);

/// A contact with the hand that presses into it.
struct TuningSituation {
  ContactSituation contact;
  Wrench push;
  double theory = 0;  ///< stiffness up to which the linear contact is stable in a light hand, N/m
};

/// One situation of a study, with one device and one hand.
struct TuningSetup {
  ClosedLoopSetup loop;
  TuningSituation situation;
  double low = 1, high = 1e5;  ///< stiffness, N/m
  double ratio = 1.02;
  double rotation_per_translation =
      1;                    ///< m²: what makes a rotational range of a translational one
  double most_damping = 0;  ///< virtual, N·s/m
  double most_rotational_damping = 0;  ///< N·m·s/rad
};

Press press_of(const TuningSituation& situation);

/// Gains well within what theory allows: half of it, without damping. What a sweep does not change
/// stays there.
void set_base_gains(TuningSetup& setup);

/// Sweeps one axis of the gains; with `whole` over dampings and their neighbourhoods, for the map,
/// else at the damping that theory likes best. JSON: {"columns": [{damping, theory_stable,
/// theory_passive, stable, good, ..., "runs": [...]}, ...]}.
std::string sweep_gains(const TuningSetup& setup, GainAxis axis, bool whole, const Stop& stop);

}  // namespace sonde
