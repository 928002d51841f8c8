// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/hand/direct_hand.hpp"

#include <algorithm>

#include "engine/geometry/rotation.hpp"

namespace sonde {
namespace {

/// What the probe is behind by, it catches up with at this multiple of the mouse's speed at most.
/// (With a target every 10 ms after one that took 110 ms, it has caught up after that time.)
constexpr double catching_up = 2;

/// Up to this, a loop that is behind does not slow the probe down.
constexpr double hardly_behind = 0.5;

}  // namespace

double DirectHand::part() const noexcept { return gone_ < duration_ ? gone_ / duration_ : 1; }

Pose DirectHand::now() const noexcept {
  const double done = part();
  if (done >= 1) return to_;
  return {rotation_between(from_.q, to_.q, done), from_.p + done * (to_.p - from_.p)};
}

double DirectHand::pace(double dt) noexcept {
  if (!(behind_ > hardly_behind)) waited_ = 0;
  const double share = std::clamp((1 - behind_) / (1 - hardly_behind), 0.0, 1.0);
  if (share >= 1 || waited_ >= longest_wait) return 1;
  waited_ += (1 - share) * dt;
  return share;
}

Pose DirectHand::next(double dt) noexcept {
  // dt = 0: the first sample of a run (also after the probe was placed), or after a pause of the
  // loop.
  const bool paused = !(dt > 0);
  since_ = paused ? longest_pause : since_ + dt;
  gone_ = paused ? duration_ : gone_ + pace(dt) * dt;
  if (targets_.update()) {
    from_ = now();
    to_ = targets_.front();
    // After a delay of the window, or of the loop, the probe catches up gradually.
    const double interval = paused ? 0 : std::min(since_, longest_pause);
    mouse_ = (1 - part()) * mouse_ + interval;
    duration_ = std::max(interval, mouse_ / catching_up);
    since_ = gone_ = 0;
  }
  return now();
}

}  // namespace sonde
