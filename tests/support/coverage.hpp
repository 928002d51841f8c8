// SPDX-License-Identifier: GPL-3.0-or-later
// Do a few rows stand for all pairs of triangles within reach?
#pragma once

#include <gtest/gtest.h>

#include <span>
#include <vector>

#include "engine/geometry/transform.hpp"
#include "engine/proximity/queries/near_pairs.hpp"
#include "engine/proximity/triangles/triangle_pair.hpp"

namespace sonde::test {

/// A pair of triangles within reach, with its corners.
struct ReachedPair {
  NearPair row;
  Corners a, b;
};

/// All pairs within reach that do not meet, by closest_points of every pair; those
/// nearer than rounding, or with no direction that separates them, have no normal to stand for.
std::vector<ReachedPair> pairs_in_reach(const Body& a, const Body& b, const Transform& X_BA,
                                        double reach);

/// How dense rows must be.
struct Density {
  double spacing;    ///< m between points on A
  double cos_angle;  ///< of the angle between normals
  double rounding;   ///< what a gap may be off by, m
};

/// Does the row stand for the pair: is its gap no larger, its normal within the angle, and its
/// point on A within the spacing of a closest point of the pair, whichever of them where faces or
/// edges are parallel? True only where such a point was found: a point of triangle A, no farther
/// from triangle B than the gap (and rounding).
bool stands_for(const NearPair& row, const ReachedPair& pair, const Density& density);

/// Does every pair have a row that stands for it? Pairs at `reach` or beyond are not asked for.
testing::AssertionResult covers(std::span<const NearPair> rows, std::span<const ReachedPair> pairs,
                                double reach, const Density& density);

}  // namespace sonde::test
