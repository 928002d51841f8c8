// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace sonde {

/// Chooses how far the next list of pairs (neighbour_list.hpp) reaches. A list that reaches further
/// takes longer to make and serves longer. Which reach costs least depends on how the surfaces lie,
/// so it is found on the way. While the cost of a list for the travel that it allows falls, the
/// reach keeps growing (or shrinking). Where the cost rises, it turns back.
class NeighbourReach {
 public:
  /// `radius`: of the probe, m.
  explicit NeighbourReach(double radius);

  /// True if a list for travel of `wanted` (m) is not worth making. It is tried again some time.
  bool is_too_far(double wanted) noexcept;
  /// m: the reach to try where at least `wanted` (m) is needed.
  double choose(double wanted) const noexcept;
  /// m: the least reach worth trying for that.
  static double least(double wanted) noexcept;
  /// Work, in the units of Effort, after which a build continues with the least reach.
  std::int64_t most_work() const noexcept;
  /// Learns what became of the list that was chosen: whether its pairs fit, the work that it took,
  /// and the work that it should take at most. After a list that did not fit the next reaches less
  /// far, and in the end none is made.
  void learn(double wanted, double chosen, bool fits, std::int64_t work,
             std::int64_t affordable) noexcept;

 private:
  double radius_;
  double limit_;         // m: lists of this reach were found to fit; grows slowly with time
  double reach_;         // m
  double too_far_;       // m: travel for which no list is made
  double cost_ = 0;      // of the last list, for its travel; 0: there was none
  double factor_;        // from one reach to the next
  double cheapest_ = 0;  // the least work of recent lists; rises slowly with time
};

}  // namespace sonde
