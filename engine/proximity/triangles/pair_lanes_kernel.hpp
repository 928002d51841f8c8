// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel of pair_lanes.hpp, for the number of lanes that the including source sets (lanes.hpp).
#pragma once

#include "engine/proximity/triangles/pair_lanes.hpp"
#include "engine/simd/lanes.hpp"

namespace sonde {

template <int lanes>
void gaps_at_in_lanes(const PairLanes& pairs, const ArmMap& at, double (&gap)[8]);
template <int lanes>
void gaps_along_in_lanes(const PairLanes& pairs, const ArmMap& from, const ArmMap& to,
                         const ArmMap& bend, PathLanes& out);
template <>
void gaps_at_in_lanes<SONDE_LANES>(const PairLanes& pairs, const ArmMap& at, double (&gap)[8]);
template <>
void gaps_along_in_lanes<SONDE_LANES>(const PairLanes& pairs, const ArmMap& from, const ArmMap& to,
                                      const ArmMap& bend, PathLanes& out);

}  // namespace sonde

SONDE_LANES_BEGIN
namespace sonde::lanes {
namespace {

/// The normal in A's axes: normal·(R arm) = (Rᵀ normal)·arm.
inline Vector turned_back(const double (&R)[3][3], const Vector& n) {
  const auto column = [&](int k) {
    return broadcast(R[0][k]) * n.x + broadcast(R[1][k]) * n.y + broadcast(R[2][k]) * n.z;
  };
  return {column(0), column(1), column(2)};
}

struct Arms {
  Vector corner[3];
  Arms(const PairLanes& pairs, int first)
      : corner{load(pairs.arm[0], first), load(pairs.arm[1], first), load(pairs.arm[2], first)} {}
  Number least(const Vector& n) const {
    return smaller(smaller(dot(n, corner[0]), dot(n, corner[1])), dot(n, corner[2]));
  }
  Number most(const Vector& n) const {
    return larger(larger(dot(n, corner[0]), dot(n, corner[1])), dot(n, corner[2]));
  }
};

inline Number gap(const Arms& arms, const Vector& n, Number top, const ArmMap& at) {
  const Number centre =
      broadcast(at.p[0]) * n.x + broadcast(at.p[1]) * n.y + broadcast(at.p[2]) * n.z;
  return arms.least(turned_back(at.R, n)) + (centre - top);
}

}  // namespace
}  // namespace sonde::lanes

namespace sonde {

template <>
void gaps_at_in_lanes<SONDE_LANES>(const PairLanes& pairs, const ArmMap& at, double (&gap)[8]) {
  for (int first = 0; first < 8; first += SONDE_LANES) {
    const lanes::Arms arms(pairs, first);
    const lanes::Vector n = lanes::load(pairs.normal, first);
    lanes::store(gap + first, lanes::gap(arms, n, lanes::load(pairs.top + first), at));
  }
}

template <>
void gaps_along_in_lanes<SONDE_LANES>(const PairLanes& pairs, const ArmMap& from, const ArmMap& to,
                                      const ArmMap& bend, PathLanes& out) {
  for (int first = 0; first < 8; first += SONDE_LANES) {
    const lanes::Arms arms(pairs, first);
    const lanes::Vector n = lanes::load(pairs.normal, first);
    const lanes::Number top = lanes::load(pairs.top + first);
    lanes::store(out.from + first, lanes::gap(arms, n, top, from));
    lanes::store(out.to + first, lanes::gap(arms, n, top, to));
    lanes::store(out.bend + first, arms.most(lanes::turned_back(bend.R, n)));
  }
}

}  // namespace sonde
SONDE_LANES_END
