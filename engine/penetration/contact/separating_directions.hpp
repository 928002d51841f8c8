// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/proximity/triangles/triangle_pair.hpp"

namespace sonde {

/// Triangles of A and B that touch, in the fixed frame.
struct TouchingPair {
  Corners a, b;
  Vec3 face_a, face_b;  ///< unit normals, outwards where the body is a solid
};
TouchingPair touching_pair(const Corners& a, const Corners& b);

/// The displacement that separates two triangles, m: the least overlap along the axes of the
/// separating-axis theorem (no direction gives less). Negative if one of these axes separates the
/// pair. Returns early at an overlap of at most `enough`.
double overlap_of(const TouchingPair& pair, double enough);

/// For each pair a direction (unit, from B to A) along which its overlap is at most `slack`, m.
/// Where triangles touch, many directions may separate one pair, and most of them contradict those
/// of its neighbours. So the direction that separates the most pairs is chosen first (greedy set
/// cover). Thus one direction serves all pairs of a convex contact, even if edges or corners meet
/// there. Candidates are the face normals, then the cross products of edges, then the directions in
/// the plane of a face across its edges. A pair in one plane is separated only towards the outside
/// of the solids. No value if a pair has no direction, or if there are too many
/// (ContactTuning::most_directions).
std::optional<std::vector<Vec3>> separating_directions(std::span<const TouchingPair> pairs,
                                                       bool solid_a, bool solid_b, double slack);

}  // namespace sonde
