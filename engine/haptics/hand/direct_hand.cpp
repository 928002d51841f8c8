// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/hand/direct_hand.hpp"

#include <algorithm>

#include "engine/geometry/rotation.hpp"

namespace sonde {
namespace {

/// Factor on the duration of the motion from one target to the next, after a target that came late.
/// (With a target every 10 ms after one that took 110 ms, the probe moves at up to 1.7, 2.4 and 3.3
/// times the speed of the mouse with 0.9, 0.8 and 0.7, and has caught up after 180, 100 and 70 ms.)
constexpr double shortened_to = 0.8;

}  // namespace

Pose DirectHand::now() const noexcept {
  if (since_ >= duration_) return to_;
  const double part = since_ / duration_;
  return {rotation_between(from_.q, to_.q, part), from_.p + part * (to_.p - from_.p)};
}

Pose DirectHand::next(double dt) noexcept {
  // dt = 0: the first sample of a run (also after the probe was placed), or after a pause of the
  // loop.
  since_ = dt > 0 ? since_ + dt : 2 * longest_pause;
  if (targets_.update()) {
    from_ = now();
    to_ = targets_.front();
    // After a delay of the window, the probe catches up gradually.
    duration_ = since_ <= longest_pause ? std::max(since_, shortened_to * duration_) : 0;
    since_ = 0;
  }
  return now();
}

}  // namespace sonde
