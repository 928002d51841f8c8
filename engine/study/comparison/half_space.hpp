// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/body/body.hpp"

namespace sonde {

/// The half-space n·x ≤ offset is solid.
struct Plane {
  Vec3 normal = Vec3::UnitZ();                                           ///< unit, outwards
  double offset = 0;                                                     ///< m
  double height(const Vec3& x) const { return normal.dot(x) - offset; }  ///< m
};

struct HalfSpaceSeparation {
  double depth = 0;  ///< √PD_g, m
  Pose separated;    ///< Q, X_FM
};

/// The separation of a body from a half-space by the definition of PD_g: the minimum over rotations
/// of max(0, depth(v))² + 4vᵀÎv, where depth(v) is how far the lowest vertex lies under the plane
/// after the turn. The three unknowns are searched without derivatives (the function has kinks
/// where the lowest vertex changes) from many starts. The method shares no code with the solver.
/// The result is an upper bound of the true value. In practice the search is global for bodies of
/// some hundred vertices, which is confirmed if two seeds agree.
HalfSpaceSeparation half_space_separation(const Body& body, const Pose& X_FM, const Plane& plane,
                                          std::uint64_t seed, int starts = 60);

/// The six faces of a body that is a box, in any position; none for any other body.
std::vector<Plane> box_faces(const Body& body);

/// The face of a large box that acts as a half-space on a probe: the probe reaches below it by less
/// than its radius R, and its centre of mass lies more than 3R inside every other face. Any way out
/// past those would move the centre of mass by more than 2R. No value if there is no such face.
std::optional<Plane> half_space_below(const Body& probe, const Pose& X_FM,
                                      const std::vector<Plane>& faces);

}  // namespace sonde
