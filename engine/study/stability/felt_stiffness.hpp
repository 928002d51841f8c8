// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/geometry/chart.hpp"
#include "engine/haptics/coupling/coupling.hpp"
#include "engine/penetration/contact/separation.hpp"
#include "engine/penetration/search/pair.hpp"
#include "engine/proximity/sweep/motion.hpp"

namespace sonde {

using Mat6 = Eigen::Matrix<double, 6, 6>;

/// The change of a coupling's spring with the device's pose, at one contact. A small motion of the
/// device is (δx, δφ): displacement of the probe's centre of mass (m) and rotation vector (rad),
/// both in the fixed frame; wrenches are (F, τ) about the centre of mass.
struct FeltStiffness {
  /// Object norm: −∂(F, τ)/∂(δx, δφ) at k = 1.
  Mat6 object = Mat6::Zero();
  /// Classic: the same for the displacement t (upper rows) and the rotation vector θ (lower rows).
  Mat6 classic = Mat6::Zero();
  /// Damped: of the damper of the object norm (object_damper.hpp), the force per velocity at b = 1.
  Mat6 damper = Mat6::Zero();

  Mat6 stiffness(const Coupling& coupling) const;
  /// The factor of the device's velocity: zero for the object norm.
  Mat6 damping(const Coupling& coupling) const;
};

/// In closed form (wrench_derivative.hpp) if that holds on all sides; otherwise, and for
/// translations only, by central differences of the solver's own answers: from Q, a free pose, to O
/// and to both sides of it, at the distance `step` (m, in the object norm). No value if an answer
/// fails, has no contact, or jumps on the way, nor if the step is below 1e-7 of the probe's radius:
/// within the clearance that an answer keeps, the separated pose need not follow at all.
std::optional<FeltStiffness> felt_stiffness(const Pair& pair, Method method, const Pose& X_FO,
                                            const Pose& X_FQ, double step);

/// The felt stiffness relative to the nominal one, for any k. In translation: the largest
/// resistance to a displacement in one direction, over k. In rotation: the largest resistance to a
/// turn, over kÎ about the same axis. (Axes with Î = 0, about which a turn moves no mass, are left
/// out.)
struct StiffnessRatio {
  double translation = 0;
  double rotation = 0;
};
StiffnessRatio stiffness_ratio(const MassProperties& mass, const Pose& X_FO, const Mat6& object);

/// The same for summed penalties, one spring of stiffness k at each contact of a separation: the
/// classic way of rendering many contacts.
StiffnessRatio summed_penalty_ratio(const MassProperties& mass, const Separation& separation);

}  // namespace sonde
