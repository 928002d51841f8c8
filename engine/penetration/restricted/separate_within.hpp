// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "engine/base/error.hpp"
#include "engine/geometry/pose.hpp"
#include "engine/penetration/contact/separation.hpp"
#include "engine/penetration/search/pair.hpp"
#include "engine/penetration/search/static_options.hpp"

namespace sonde {

/// Finds the shortest translation along one of the given directions that frees the probe at X_FM. A
/// direction does not include its opposite; give both if both are allowed. Directions are in the
/// fixed frame F, of any length above 0. The result is the global minimum, except for gaps narrower
/// than rounding. The depth is √σ of the motion, which is its length. The one contact of the result
/// is where the bodies touch last; its multiplier is such that the component of its force along the
/// motion is y. The pose is free by the exact test, and lies a few rounding errors beyond the
/// contact. The cost depends on the length of the motion: 1 ms to 1 s on bundled pairs. Sets
/// neither lower_bound nor pdt. A pose that is not finite fails as in separate(). X_FM.q need not
/// have length 1. Allocates. Any number of threads may call it on one pair.
/// @throws InputError if there are no directions, or one is not finite or 0.
/// @throws Cancelled if `progress` returns false.
Separation separate_along(const Pair& pair, const Pose& X_FM, std::span<const Vec3> directions_F,
                          const Progress& progress = {});

/// The smallest turn to either side about an axis through a point, both in the fixed frame F, that
/// frees the probe. Otherwise as separate_along(). The depth is √σ of the turn: the root mean
/// square displacement of the probe's points. Status::failed if no turn about the axis frees the
/// probe.
/// @throws InputError if the axis is not finite or 0, or the point is not finite.
/// @throws Cancelled if `progress` returns false.
Separation separate_about(const Pair& pair, const Pose& X_FM, const Vec3& point_F,
                          const Vec3& axis_F, const Progress& progress = {});

/// The motions of a body that slides on a plane.
struct InPlane {
  Vec3 normal_F = Vec3::UnitZ();  ///< of the plane, in the fixed frame, of any length above 0
  bool turning = true;            ///< it may also turn about the normal; false: it only slides
};

/// Searches for the depth among the motions in a plane, by descents from random starts: first from
/// outside the fixed body, then from free poses near by. There are `starts` descents, or fewer if
/// `agreement` of the later ones agree. The result is an upper bound; its pose is free by the exact
/// test. `lower_bound` is that of all motions, which also holds for a subset. Of the other options,
/// the seed, the time budget and want_lower_bound work as in separate(); the rest have no effect.
/// The contacts satisfy y = P Jᵀλ, with P the projection onto the motions. `pdt` is not set.
/// Allocates. For threads and X_FM.q, see separate_along().
/// @throws InputError if the normal is not finite or 0, or as separate().
/// @throws Cancelled if `progress` returns false.
Separation separate_in_plane(const Pair& pair, const Pose& X_FM, const InPlane& motions,
                             const StaticOptions& options = {}, const Progress& progress = {});

}  // namespace sonde
