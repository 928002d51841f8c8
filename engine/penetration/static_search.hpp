// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "engine/geometry/body.hpp"
#include "engine/penetration/separation.hpp"
#include "engine/proximity/sketch.hpp"

namespace sonde {

struct StaticOptions {
  Method method = Method::pdg;
  Budget budget;
  std::uint64_t seed = 1;
  int starts = 384;  ///< random free starts at most; fewer where the same depth is found repeatedly
  int agreement = 12;  ///< so many starts that ended at the best depth (to 2 %) are enough
  bool want_lower_bound = true;
  bool two_threads = false;  ///< the same bits; where a budget of time is short, one works alone
  /// Of the same two bodies (make_sketches): the search is quicker, and better where time is short.
  Sketches sketches = {};
};

/// Generalized (or translational) penetration depth of probe A at X_FM against fixed body B,
/// searched globally from many starts, each descended on the contact space. The separated pose is
/// verified free with exact predicates. Never throws on geometry: a failure says so in the result.
/// Allocates.
Separation separate_static(const Body& probe, const Body& fixed, const Pose& X_FM,
                           const StaticOptions& options = {});

}  // namespace sonde
