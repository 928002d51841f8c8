// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace sonde {

/// Chooses the reach of the next list of pairs (neighbour_list.hpp). A list with a larger reach
/// takes longer to make and serves longer. The cheapest reach depends on the position of the
/// surfaces relative to each other, so it is found by hill climbing: the reach keeps growing (or
/// shrinking) as long as the cost of a list, for the travel that it allows, falls; when the cost
/// rises, the direction is reversed.
class NeighbourReach {
 public:
  /// `radius`: the probe's radius, m.
  explicit NeighbourReach(double radius);

  /// True if a list for travel of `wanted` (m) is not worth making. Each such answer raises the
  /// limit a little, so that longer lists are tried again after a time.
  bool is_too_far(double wanted) noexcept;
  /// m: the reach to try if at least `wanted` (m) is needed.
  double choose(double wanted) const noexcept;
  /// m: the least reach worth trying if `wanted` (m) is needed.
  static double least(double wanted) noexcept;
  /// Work, in the units of Effort, after which a build continues with the least reach.
  std::int64_t most_work() const noexcept;
  /// Learns from the list that was chosen: whether its pairs fit, the work that it took, and the
  /// work that it should take at most. After a list that did not fit, the next one has a smaller
  /// reach, and after several none is made.
  void learn(double wanted, double chosen, bool fits, std::int64_t work,
             std::int64_t affordable) noexcept;

 private:
  double radius_;
  double limit_;         // m: lists of this reach fitted; grows slowly with time
  double reach_;         // m
  double too_far_;       // m: travel for which no list is made
  double cost_ = 0;      // cost of the last list; 0: there was none
  double factor_;        // ratio of one reach to the last
  double cheapest_ = 0;  // the least work of recent lists; rises slowly with time
};

}  // namespace sonde
