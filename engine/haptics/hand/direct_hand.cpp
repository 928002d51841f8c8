// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/hand/direct_hand.hpp"

#include <algorithm>

#include "engine/geometry/rotation.hpp"

namespace sonde {
namespace {

/// From one target to the next, after a slow one. (Pictures 10 ms apart after one that took 110:
/// the probe goes at up to 1.7, 2.4 and 3.3 times the speed of the mouse with 0.9, 0.8 and 0.7, and
/// has caught up after 180, 100 and 70 ms.)
constexpr double shortened_to = 0.8;

}  // namespace

Pose DirectHand::now() const noexcept {
  if (since_ >= over_) return to_;
  const double part = since_ / over_;
  return {rotation_between(from_.q, to_.q, part), from_.p + part * (to_.p - from_.p)};
}

Pose DirectHand::next(double dt) noexcept {
  // 0: the first sample of a run, as after a place, or after a pause of the loop.
  since_ = dt > 0 ? since_ + dt : 2 * longest_pause;
  if (targets_.update()) {
    from_ = now();
    to_ = targets_.front();
    // What a window that stood still is behind is caught up with little by little.
    over_ = since_ <= longest_pause ? std::max(since_, shortened_to * over_) : 0;
    since_ = 0;
  }
  return now();
}

}  // namespace sonde
