// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>

#include "engine/proximity/queries/near_pairs.hpp"

namespace sonde::test {

/// The numbers of a triangle of the probe and of one of the fixed body.
using PairKey = std::pair<std::uint32_t, std::uint32_t>;

/// The gap of each pair.
inline std::map<PairKey, double> gaps(std::span<const NearPair> pairs) {
  std::map<PairKey, double> out;
  for (const NearPair& p : pairs) out[{p.triangle_a, p.triangle_b}] = p.gap;
  return out;
}

}  // namespace sonde::test
