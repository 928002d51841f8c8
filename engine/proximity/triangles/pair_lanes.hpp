// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps of eight pairs of triangles at a time, each along a known separating direction.
#pragma once

#include "engine/geometry/pose.hpp"
#include "engine/proximity/triangles/triangle_lanes.hpp"

namespace sonde {

/// Up to eight pairs: [corner][coordinate][lane] and [coordinate][lane], m.
struct alignas(64) PairLanes {
  double arm[3][3][8] = {};  ///< corners of the triangle of A from A's centre, A's axes
  double normal[3][8] = {};  ///< unit, from B to A, in B's frame
  double top[8] = {};        ///< max over the triangle of B of normal·b
};

/// The pose of A: x = R arm + p, where p is the position of its centre. Or the acceleration of its
/// points as a function of the arm.
struct ArmMap {
  double R[3][3];
  double p[3];
};
ArmMap arm_map(const Mat3& R, const Vec3& p);

/// min over A's corners of normal·x − top, in each lane.
void gaps_at(const PairLanes& pairs, const ArmMap& at, double (&gap)[8]);

/// The data to decide whether a path is clear: the gaps at its two ends, and the largest
/// acceleration of a corner along the normal, normal·(bend.R arm).
struct PathLanes {
  alignas(64) double from[8], to[8], bend[8];
};
void gaps_along(const PairLanes& pairs, const ArmMap& from, const ArmMap& to, const ArmMap& bend,
                PathLanes& out);

/// The same by one instruction set, which must be supported. All give the same bits.
void gaps_at_by(InstructionSet set, const PairLanes& pairs, const ArmMap& at, double (&gap)[8]);
void gaps_along_by(InstructionSet set, const PairLanes& pairs, const ArmMap& from, const ArmMap& to,
                   const ArmMap& bend, PathLanes& out);

}  // namespace sonde
