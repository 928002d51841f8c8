// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/falls.hpp"

#include <algorithm>
#include <utility>

namespace sonde {
namespace {

/// Share of the allowed clearance: the largest gap of a probe in contact (twice the gap aimed at).
/// A loss of depth within it does not count as a fall.
constexpr double gap_of_held = 2 * Descent::gap_of_follower;
/// Factor on the device's motion. In a flat metric, the slope that a device motion causes equals
/// its length; turns curve the metric, by a few per cent at the angles of one tick.
constexpr double bend_of_metric = 1.1;
/// Share of the product of the device's and the separated probe's motions. The energy of a tick is
/// computed from the forces at its two ends, so a tick in which contacts come and go seems to
/// release this much of σ. (For a peg pressed onto the bottom of its hole: without this tolerance,
/// three more ticks count as jumps, which they do not if the steps of the device are a quarter as
/// long. The real falls are found at every step length.)
constexpr double bend_of_force = 0.1;
/// Share of the energy that the gap at the contacts amounts to: what a probe that is behind lets go
/// beyond that is said. (Of a ball in its socket with 50 000 units a tick, 1.47 % of the energy
/// went unsaid where lag was not; with 1, 0.5, 0.25, 0.125 and 0 it is 0.30, 0.14, 0.10, 0.08 and
/// 0.08 %, and 60, 88, 103, 112 and 125 ticks say so. 128 do not converge.)
constexpr double said_of_lag = 0.25;

}  // namespace

double Falls::held_slope(double moved) const noexcept { return bend_of_metric * (moved + lag_); }

/// The tick before found a local optimum. As long as the pose stays one, the depth changes by no
/// more than the device moves, and the probe descends no more steeply than the device has moved
/// since.
bool Falls::fell(const Tick& tick) const noexcept {
  const bool far = tick.depth < tick.before - tick.moved * (1 + 1e-9) - 2 * tick.clearance;
  const bool steeply = turns_ && tick.fallen > gap_ * tick.clearance * tick.before;
  return tick.let_go > bend_of_force * tick.moved * tick.way && (far || steeply);
}

/// A probe that was behind comes down no faster than the device has moved since, but what it lets
/// go is lost all the same, however many ticks it takes.
bool Falls::let_go_behind(const Tick& tick) noexcept {
  const bool behind = turns_ && tick.before > 0 && (lag_ > 0 || !tick.converged);
  unsaid_ = behind ? std::max(0.0, unsaid_ + tick.let_go) : 0;
  return unsaid_ > said_of_lag * 2 * gap_ * tick.clearance * tick.before;
}

std::optional<Falls::Release> Falls::released(const Tick& tick) noexcept {
  const bool lagged = let_go_behind(tick), left_optimum = fell(tick);
  lag_ = tick.converged ? 0 : lag_ + tick.moved;
  if (tick.converged) gap_ = gap_of_held;
  if (!lagged && !left_optimum) return std::nullopt;
  return Release{std::max(tick.let_go, std::exchange(unsaid_, 0.0)), !left_optimum};
}

}  // namespace sonde
