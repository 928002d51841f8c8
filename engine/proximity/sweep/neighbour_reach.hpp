// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace sonde {

/// How far the next list of pairs (neighbour_list.hpp) is to reach. One that reaches further takes
/// longer to make and serves longer; which reach costs least depends on how the surfaces lie. So
/// it is found on the way: as long as what a list costs for the travel that it allows falls, the
/// reach goes on growing (or shrinking), and turns back where it rises.
class NeighbourReach {
 public:
  /// `radius`: of the probe, m.
  explicit NeighbourReach(double radius);

  /// Is a list for travel of `wanted`, m, not worth making? It is given another try some time.
  bool is_too_far(double wanted) noexcept;
  /// The reach to try, m, where so much is wanted at least; and the least one worth trying.
  double choose(double wanted) const noexcept;
  static double least(double wanted) noexcept;
  /// A list that takes more work is to go on with the least reach.
  std::int64_t most_work() const noexcept;
  /// What became of the list that was chosen: the units of work that it took, and those that it
  /// should take at most. What does not fit is made smaller, and after that given up.
  void learn(double wanted, double chosen, bool fits, std::int64_t work,
             std::int64_t affordable) noexcept;

 private:
  double radius_;
  double limit_;         // m: so far it was found to fit, with time further
  double reach_;         // m
  double too_far_;       // m
  double cost_ = 0;      // of the last one for its travel; 0: there is none
  double factor_;        // from one reach to the next
  double cheapest_ = 0;  // work of late, rising with time
};

}  // namespace sonde
