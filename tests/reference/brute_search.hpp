// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "engine/body/body.hpp"
#include "engine/penetration/contact/separation.hpp"

namespace sonde::reference {

struct BruteOptions {
  Method method = Method::pdg;
  int directions = 60;  ///< along which the probe comes in from outside
  int starts = 400;     ///< random free poses descended after that
  int hops = 100;       ///< free poses near the best so far descended after those
  int polished = 12;    ///< of the answers so far, the best that differ
  std::uint64_t seed = 1;
};

/// Where the descent that led to the best began.
enum class Origin { outside, random, hop };
const char* name(Origin origin);

struct BruteResult {
  double depth = 0;  ///< m; infinite where nothing found stood the exact test
  Pose separated;    ///< X_FM, free by the exact test
  Origin origin = Origin::outside;
  /// What each random start came to before polishing, m: at most BruteOptions::starts of them, for
  /// now and then no free pose is found.
  std::vector<double> reached;
};

/// The least depth that very many descents find, without regard to time: the reference that the
/// static search is measured by. They begin outside the fixed body, at free poses in a ball about
/// the device pose somewhat larger than the best depth so far (a quarter of them: much smaller, for
/// where bodies are linked a small motion may do what a large one cannot), and about the best.
/// Local steps are the engine's (Descent); where they begin and which of them count is decided
/// here. It is an upper bound of the true depth itself; how often it comes out the same with other
/// seeds says how far it can be trusted.
BruteResult brute_search(const Body& probe, const Body& fixed, const Pose& X_FM,
                         const BruteOptions& options);

}  // namespace sonde::reference
