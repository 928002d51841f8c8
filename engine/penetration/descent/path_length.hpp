// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace sonde {

/// How long a path may be so that its sweep does not take too much work, learned from the sweeps
/// of a descent. Where parts fit all round, that work grows with about the cube of the length.
class PathLength {
 public:
  void forget() noexcept { *this = {}; }
  /// m: limit of the next path, by the largest motion of a point of the probe.
  double longest() const noexcept { return longest_; }
  /// A path of `length` (m) was given up. `by_itself`: not because the tick's effort was spent.
  void gave_up(double length, bool by_itself) noexcept;
  /// A path was swept to its end or to an obstacle.
  void went() noexcept;

 private:
  double longest_ = std::numeric_limits<double>::infinity();
  double given_up_ = std::numeric_limits<double>::infinity();  // m: grows with each path after that
};

}  // namespace sonde
