// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/triangles/pair_lanes.hpp"

#define SONDE_LANES 2
#include "engine/proximity/triangles/pair_lanes_kernel.hpp"

namespace sonde {

ArmMap arm_map(const Mat3& R, const Vec3& p) {
  ArmMap out{};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) out.R[i][k] = R(i, k);
    out.p[i] = p[i];
  }
  return out;
}

void gaps_at_by(InstructionSet set, const PairLanes& pairs, const ArmMap& at, double (&gap)[8]) {
#ifdef __x86_64__
  if (set == InstructionSet::avx512) return gaps_at_in_lanes<8>(pairs, at, gap);
  if (set == InstructionSet::avx2) return gaps_at_in_lanes<4>(pairs, at, gap);
#endif
  gaps_at_in_lanes<2>(pairs, at, gap);
}

void gaps_along_by(InstructionSet set, const PairLanes& pairs, const ArmMap& from, const ArmMap& to,
                   const ArmMap& bend, PathLanes& out) {
#ifdef __x86_64__
  if (set == InstructionSet::avx512) return gaps_along_in_lanes<8>(pairs, from, to, bend, out);
  if (set == InstructionSet::avx2) return gaps_along_in_lanes<4>(pairs, from, to, bend, out);
#endif
  gaps_along_in_lanes<2>(pairs, from, to, bend, out);
}

void gaps_at(const PairLanes& pairs, const ArmMap& at, double (&gap)[8]) {
  gaps_at_by(instruction_set(), pairs, at, gap);
}

void gaps_along(const PairLanes& pairs, const ArmMap& from, const ArmMap& to, const ArmMap& bend,
                PathLanes& out) {
  gaps_along_by(instruction_set(), pairs, from, to, bend, out);
}

}  // namespace sonde
