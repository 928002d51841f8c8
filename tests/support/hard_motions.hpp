// SPDX-License-Identifier: GPL-3.0-or-later
// Motions that are hard on a sweep, by seed.
#pragma once

#include <optional>
#include <random>

#include "engine/geometry/chart.hpp"
#include "engine/proximity/sweep/motion.hpp"
#include "tests/support/pairs.hpp"

namespace sonde::test {

/// A path of a body from a free pose.
struct HardMotion {
  enum class Kind {
    translation,  ///< through or past a pose picked among contacts
    rotation,     ///< about the centre of mass, through such a pose
    screw,        ///< both
    turning_far,  ///< both ends at up to |v| = 0.95 of the chart
    tiny,         ///< 1e-9 to 1e-3 of the bodies' size, from near a contact
    fast,         ///< 10 to 1e5 sizes long, through a contact
    leaving,      ///< from almost touching, any way
    sliding,      ///< from almost touching, along the plane between
  };
  static constexpr int kinds = 8;
  Chart chart;
  Vec6 from, to;
  double clearance;
  /// Where the path goes through the pose that was picked, if it does.
  double picked = -1;
  Motion motion() const { return {chart, from, to}; }
};

/// None where no free start was found.
std::optional<HardMotion> hard_motion(HardMotion::Kind kind, const BodyPair& pair,
                                      std::mt19937_64& random);
const char* name(HardMotion::Kind kind);

}  // namespace sonde::test
