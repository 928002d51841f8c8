// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "engine/penetration/contact/separation.hpp"
#include "engine/penetration/search/pair.hpp"

namespace sonde {

/// What a static search is asked for.
struct StaticOptions {
  Method method = Method::pdg;
  Budget budget;           ///< its steps and microseconds; none: until it has converged
  std::uint64_t seed = 1;  ///< of the random starts; any number
  int starts = 384;  ///< random free starts at most; fewer where the same depth is found repeatedly
  int agreement = 12;  ///< so many starts that ended at the best depth (to 2 %) are enough
  /// Also enough: sketches of the bodies that leave no doubt, or starts from all that they show.
  /// False: as many starts as above, or the agreement, whatever sketches say.
  bool by_evidence = true;
  bool want_lower_bound = true;  ///< also; there is none where both bodies are surfaces
  /// Of a budget of time: kept for the bound. 0: it gets what the search leaves.
  double share_for_bound = 0;
  bool two_threads = false;  ///< the same bits; where a budget of time is short, one works alone
};

// Not of the public face from here on (engine/sonde.hpp).

/// Generalized (or translational) penetration depth of probe A at X_FM against fixed body B,
/// searched globally on the pair's sketches and from many starts, each descended on the contact
/// space. The separated pose is verified free with exact predicates. Never throws on geometry: a
/// failure says so in the result. Allocates.
Separation separate_static(const Pair& pair, const Pose& X_FM, const StaticOptions& options = {});
/// The same with other numbers than the search's own (search_tuning.hpp), for studies of them.
struct SearchTuning;
Separation separate_static(const Pair& pair, const Pose& X_FM, const StaticOptions& options,
                           const SearchTuning& tuning);

}  // namespace sonde
