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

/// How far two triangles must be moved apart, m: the least overlap along the axes of the
/// separating-axis theorem (no direction gives less). Below 0 where one of them separates the pair.
/// It stops looking at an overlap of at most `enough`.
double overlap_of(const TouchingPair& pair, double enough);

/// For each pair a direction (unit, from B to A) along which its overlap is at most `slack`, m.
/// Where triangles touch, many directions may separate one pair, and most of them contradict those
/// of its neighbours: the direction that separates the most pairs is taken first (a greedy cover),
/// so that one direction serves for all of a convex contact, also where edges or corners meet.
/// Candidates are the normals of the faces, where those leave something the cross products of
/// edges, and the directions in the plane of a face across its edges. A pair in one plane is
/// separated across it to the outside of what is solid alone. No value where a pair has no
/// direction, or there are too many (ContactTuning::most_directions).
std::optional<std::vector<Vec3>> separating_directions(std::span<const TouchingPair> pairs,
                                                       bool solid_a, bool solid_b, double slack);

}  // namespace sonde
