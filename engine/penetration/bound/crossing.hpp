// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "engine/base/deadline.hpp"
#include "engine/body/body.hpp"
#include "engine/geometry/transform.hpp"

namespace sonde {

/// A proof that two bodies overlap which also works for surfaces, which have no inside: a curve on
/// the surface of one body pierces a patch of the other body's surface an odd number of times. As
/// long as each point of the curve is displaced by less than `depth`, no end of the curve reaches
/// the patch, and no point of the curve reaches the patch's border. So the number stays odd, and
/// the surfaces still meet. The proof is in "Lower bound" of
/// resources/docs/understand/mathematics.md.
struct Crossing {
  Vec3 at = Vec3::Zero();  ///< where the curve pierces the patch, in the fixed body's mesh frame, m
  double depth = 0;        ///< rounded down, m
  double bound = 0;        ///< of √σ, that it proves: depth / √price, m
};

struct CrossingSearch {
  double beat = 0;  ///< m: only larger bounds are of use
  double reach;     ///< m: radius of the region examined about a place where triangles meet
  /// Limit of the counted work: comparisons of a piece of a curve with a triangle or a border. If
  /// it acts, fewer places and directions are tried, and the bound may be lower.
  int work = 2'000'000;
  Deadline deadline = {};
  /// The price of displacing a point (fixed body's mesh frame): a motion of cost σ displaces it by
  /// no more than √(σ · price). At least 1.
  std::function<double(const Vec3&)> price;
};

/// The crossing with the largest bound of those found: curves that planes cut from either surface,
/// about some of the places where triangles meet, and patches without sharp edges. All 0 if none
/// was found that proves more than `beat`. Allocates.
Crossing best_crossing(const Body& probe, const Body& fixed, const Transform& X_FM,
                       const CrossingSearch& search);

}  // namespace sonde
