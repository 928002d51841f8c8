// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "engine/base/phase_times.hpp"
#include "engine/penetration/bound/lower_bound.hpp"
#include "engine/penetration/contact/separation.hpp"
#include "engine/penetration/search/pair.hpp"

namespace sonde {

/// A separated pose found by a global search.
struct FoundSeparation {
  double depth = 0;  ///< √σ from the device pose, m; 0 if that pose is free
  Pose separated;
};

/// The result of computations that are too slow for a tick. A separate thread does them for the
/// newest requested pose, only while requests arrive.
struct BackgroundResult {
  Pose device;  ///< the pose that was searched
  /// The nearest pose of both searches: an upper bound of PD_g.
  std::optional<FoundSeparation> nearest;
  /// Translation only; none if the search failed. Never longer than the translation of `nearest`,
  /// if that alone separates the bodies.
  std::optional<FoundSeparation> pdt;
  std::optional<double> lower_bound;         ///< of √PD_g, m
  std::optional<BoundWitness> witness = {};  ///< of that bound
  /// Separation::far_out of the search that found `nearest`. If `nearest` is the pose that the loop
  /// followed, it is that of the search whose result was farther away.
  bool far_out = false;
  double budget_us = 0;  ///< of each of the two searches; 0: none
  double sure = 0.9;     ///< StaticOptions::sure of both
  double time_us = 0;
  PhaseTimes phases = {};  ///< of both searches and the bound, if recorded
};

/// The same without a time limit, in the calling thread: the same bits every time, except for its
/// times.
BackgroundResult searched_fully(const Pair& pair, const Pose& X_FM);

/// The result, with `nearest` replaced by the separated pose that the loop followed, if that is
/// nearer: it separates the bodies from the same device pose, and a short search may miss it.
BackgroundResult with_followed(BackgroundResult search, const Separation& followed);

/// How the separated pose that the loop followed compares with the result of the global search from
/// the same device pose.
enum class WayOut {
  unknown,         ///< the search answered for another pose, or not at all
  nearest,         ///< the search knows no nearer pose
  nearer_blocked,  ///< there is a nearer pose, but no free path to it from where the probe came
  free_blocked,    ///< the device pose itself is free, but the path to it is blocked
};
WayOut way_out(const Separation& followed, const BackgroundResult& search);
/// A sentence for the window; "" if there is nothing to say.
const char* words(WayOut way);

/// Searches in its own thread for the nearest separated poses of the newest requested device pose.
class BackgroundSearch {
 public:
  explicit BackgroundSearch(const Pair& pair);
  ~BackgroundSearch();
  BackgroundSearch(const BackgroundSearch&) = delete;
  BackgroundSearch& operator=(const BackgroundSearch&) = delete;
  /// Replaces a request not yet begun. `known`: a separated pose already known for that device
  /// pose, for example the one that the loop followed. If its translation alone also separates the
  /// bodies, PD_t is at most the length of that translation.
  void request(const Pose& X_FM, const std::optional<Pose>& known = {});
  /// Whether results report where their time went, for requests from now on; off initially.
  void set_time_phases(bool on);
  /// Sets StaticOptions::sure of the searches from now on; 0.9 initially. A pose whose result was
  /// computed with another value is searched again.
  void set_sure(double share);
  std::optional<BackgroundResult> latest();  ///< the newest finished result, if any

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sonde
