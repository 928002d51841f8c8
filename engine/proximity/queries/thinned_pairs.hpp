// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "engine/body/body.hpp"
#include "engine/proximity/queries/near_pairs.hpp"

namespace sonde {

/// How much of the pairs within reach one of them may stand for.
struct Thinning {
  double spacing;    ///< largest distance of the two points on A, m
  double cos_angle;  ///< smallest cosine between the two normals
};

/// So many of the pairs within reach that each has one that stands for it: a row no further than
/// the spacing from its point on A, with a normal within the angle, and with a gap no larger. Fewer
/// rows, not less time: a pair's normal is known only once its closest points are, so the time
/// still goes with the pairs, but for those whose boxes are small beside their gap. Otherwise as
/// near_pairs: pairs that meet are left out, and where the rows do not fit, the reach returned is
/// the smaller one for which the promise holds. `out` must hold at least two. Never allocates.
NearPairs thinned_pairs(const Body& a, const Body& b, const Transform& X_BA, double reach,
                        const Thinning& thinning, std::span<NearPair> out);

}  // namespace sonde
