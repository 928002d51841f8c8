// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps of eight pairs of triangles at a time, each along a direction that is known to separate it.
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

/// Where A is: x = R arm + p, p being where its centre is. Or how its points accelerate.
struct ArmMap {
  double R[3][3];
  double p[3];
};
ArmMap arm_map(const Mat3& R, const Vec3& p);

/// min over the corners of normal·x − top, in each lane.
void gaps_at(const PairLanes& pairs, const ArmMap& at, double (&gap)[8]);

/// What is_clear (pair_list.cpp) asks of a path: the gaps at its two ends, and the largest
/// acceleration of a corner along the normal, normal·(bend.R arm).
struct PathLanes {
  alignas(64) double from[8], to[8], bend[8];
};
void gaps_along(const PairLanes& pairs, const ArmMap& from, const ArmMap& to, const ArmMap& bend,
                PathLanes& out);

/// By one of the instruction sets, which has to be supported. The same bits by all.
void gaps_at_by(InstructionSet set, const PairLanes& pairs, const ArmMap& at, double (&gap)[8]);
void gaps_along_by(InstructionSet set, const PairLanes& pairs, const ArmMap& from, const ArmMap& to,
                   const ArmMap& bend, PathLanes& out);

}  // namespace sonde
