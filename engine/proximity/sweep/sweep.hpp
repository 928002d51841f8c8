// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "engine/base/effort.hpp"
#include "engine/body/body.hpp"
#include "engine/proximity/sweep/motion.hpp"

namespace sonde {

struct Sweep {
  /// The path is free on [0, free_until]: every pair of triangles is separated along some axis by
  /// at least the clearance (or by half of its gap at the start, if that was less).
  double free_until = 0;
  bool hit = false;       ///< false: free to the end of the path
  bool given_up = false;  ///< no real hit: the effort ran out, and more of the path may be free
  std::uint32_t triangle_a = 0;  ///< the pair that stopped the path
  std::uint32_t triangle_b = 0;
};

/// Sweeps the probe along the path to the first contact. Conservative: a path reported free is
/// free. Each pair of boxes or triangles is advanced by the time in which the gap along a
/// separating axis cannot close, from the speed along that axis and a bound of the acceleration
/// (conservative advancement with directional motion bounds; after Mirtich 1996 and Tang, Kim and
/// Manocha, C2A, 2009). The start must be free: a start without a gap above the rounding error
/// gives free_until = 0. Never allocates.
///
/// Most ticks do not call this function. NeighbourList::sweep_along sweeps the pairs of a list
/// (neighbour_list.hpp), and PairSweep advances one pair of triangles (pair_sweep.hpp).
/// ContactRows::sweep_along (engine/penetration/contact) chooses between a list and this function.
Sweep sweep(const Body& probe, const Body& fixed, const Motion& motion, double clearance,
            Effort& effort);
Sweep sweep(const Body& probe, const Body& fixed, const Motion& motion, double clearance);

/// The same, but the clearance holds for all pairs, from the start on: on [0, free_until] the
/// bodies are apart by at least the clearance. The path stops where their distance is within some
/// 1e-4 of the clearance; if it is less than the clearance at the start, free_until is 0. A pair of
/// triangles whose bounds converge too slowly may stop it earlier. If the distance stays close to
/// the clearance over a long path, the sweep takes more work.
Sweep sweep_within_room(const Body& probe, const Body& fixed, const Motion& motion,
                        double clearance, Effort& effort);

}  // namespace sonde
