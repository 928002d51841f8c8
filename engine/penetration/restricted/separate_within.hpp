// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "engine/base/error.hpp"
#include "engine/geometry/pose.hpp"
#include "engine/penetration/contact/separation.hpp"
#include "engine/penetration/search/pair.hpp"
#include "engine/penetration/search/static_options.hpp"

namespace sonde {

/// The least way out of the probe at X_FM along one of the directions, each one way only: give a
/// direction and its opposite for both. Directions are in the fixed frame F, of any length above 0.
/// What is found is the least, but for gaps that are narrower than rounding: nothing is stepped
/// over. The depth is √σ of that motion, which is its length. The one contact is where the bodies
/// meet last; its multiplier is such that the part of its force along the way is y. The pose is
/// free by the exact test, and some roundings of the coordinates beyond the contact. Costs what the
/// way costs: on bundled pairs 1 ms to 1 s. Neither lower_bound nor pdt is given. A pose that is
/// not finite fails as in separate(). X_FM.q need not have length 1. Allocates, and any number of
/// threads may call it on one pair.
/// @throws InputError where there are no directions, or one is not finite or 0.
/// @throws Cancelled where `progress` returns false.
Separation separate_along(const Pair& pair, const Pose& X_FM, std::span<const Vec3> directions_F,
                          const Progress& progress = {});

/// The least turn about an axis through a point, both in the fixed frame F, to either side. The
/// rest as of separate_along(); the depth is √σ of the turn, what its points are displaced by in
/// the root mean square. Status::failed where no turn about the axis sets the probe free.
/// @throws InputError where the axis is not finite or 0, or the point is not finite.
/// @throws Cancelled where `progress` returns false.
Separation separate_about(const Pair& pair, const Pose& X_FM, const Vec3& point_F,
                          const Vec3& axis_F, const Progress& progress = {});

/// The motions of a body that slides on a plane.
struct InPlane {
  Vec3 normal_F = Vec3::UnitZ();  ///< of the plane, in the fixed frame, of any length above 0
  bool turning = true;            ///< it may turn about the normal too, else only slide
};

/// The depth among the motions in a plane, by descents from random places, first from outside, then
/// nearby: as many as `starts` says, fewer where `agreement` of the later ones agree. An upper
/// bound, and free by the exact test. `lower_bound` is that of all motions, which holds among
/// fewer. Besides, seed, a budget of time and want_lower_bound do as in separate(); the other
/// options have no effect. Where the contacts hold the pose, y = P Jᵀλ with P onto the motions.
/// `pdt` is not given. Allocates; threads and X_FM.q as above.
/// @throws InputError where the normal is not finite or 0.
/// @throws Cancelled where `progress` returns false.
Separation separate_in_plane(const Pair& pair, const Pose& X_FM, const InPlane& motions,
                             const StaticOptions& options = {}, const Progress& progress = {});

}  // namespace sonde
