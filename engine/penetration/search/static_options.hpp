// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "engine/penetration/contact/separation.hpp"

namespace sonde {

/// The options of a static search.
struct StaticOptions {
  Method method = Method::pdg;  ///< the motions to search
  /// `steps` and `microseconds` limit the search. With neither, the limits below alone end it.
  Budget budget = {};
  std::uint64_t seed = 1;  ///< seed of the random starts; any number
  /// The search descends from at most this many random starts. With evidence from sketches, it
  /// makes fewer (SearchTuning::most_after_sketches). At least 1.
  int starts = 384;
  /// The search ends when this many independent starts have ended at the best depth, to 2 %. At
  /// least 1.
  int agreement = 12;
  /// The share of answers, above 0 and below 1, that should be the global optimum to the stated
  /// accuracy. With a larger share, the search makes more starts if the separating motion is long
  /// (Separation::far_out), since agreement of starts proves nothing there.
  double sure = 0.9;
  /// Also stop if the sketches of the bodies leave no doubt, or if the search has descended from
  /// all optima that they show. False: only `starts` and `agreement` end the search.
  bool by_evidence = true;
  bool want_lower_bound = true;  ///< compute the lower bound too
  /// True: the bound uses all the work that raises it (some 5 ms). False: about as much as the
  /// search took, by count, plus its start points. The bound may then be lower. There is none if
  /// less than 0.3 ms of a time budget is left.
  bool whole_bound = false;
  /// The share of a time budget that is reserved for the bound, 0 to 1. 0: the bound gets what the
  /// search leaves.
  double share_for_bound = 0;
  /// If the pose is free, also compute the distance of the bodies (Separation::clearance), at the
  /// cost of distance().
  bool want_clearance = false;
  bool time_phases = false;  ///< report where the time went (Separation::phases)
  bool two_threads = false;  ///< same bits; with a short time budget, only one is used
};

}  // namespace sonde
