// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "engine/penetration/contact/separation.hpp"

namespace sonde {

/// The options of a static search.
struct StaticOptions {
  Method method = Method::pdg;  ///< the motions to search among
  /// `steps` and `microseconds` limit the search. With neither, the limits below alone end it.
  Budget budget = {};
  std::uint64_t seed = 1;  ///< seed of the random starts; any number
  /// The search descends from at most this many random starts. With evidence from sketches it makes
  /// fewer (SearchTuning::most_after_sketches).
  int starts = 384;
  /// The search ends when this many independent starts have ended at the best depth, to 2 %.
  int agreement = 12;
  /// The share of answers, above 0 and below 1, that should be the best there is, to the accuracy
  /// that is claimed: the more, the more starts a search makes from where the way out is long
  /// (Separation::far_out), where agreement shows nothing.
  double sure = 0.9;
  /// Also stop where the sketches of the bodies leave no doubt, or where the search has descended
  /// from all places that they show. False: only the two limits above end the search.
  bool by_evidence = true;
  bool want_lower_bound = true;  ///< compute the lower bound too; two surfaces have none
  /// The bound takes whatever work raises it (some 5 ms). False: about as much as the search took,
  /// as counted, besides the points that it begins with. It may be lower then, and there is none
  /// where a budget of time leaves less than 0.3 ms.
  bool whole_bound = false;
  /// The share of a budget of time that is kept for the bound. 0: the bound gets what the search
  /// leaves.
  double share_for_bound = 0;
  /// Where the pose is free, say how far the bodies are apart (Separation::clearance): as
  /// distance() takes.
  bool want_clearance = false;
  bool time_phases = false;  ///< say where the time went (Separation::phases)
  bool two_threads = false;  ///< the same bits; one works alone where a budget of time is short
};

}  // namespace sonde
